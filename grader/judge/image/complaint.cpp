#include "judge/image/complaint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/picture/offset_text.hpp"

namespace umbral::grader {
namespace {

const char* brightness(double difference) { return difference > 0 ? "bright" : "dark"; }

// Shares are of the content; but what is wrong outside of it may be many times as much, and is counted apart. Where no
// background can be told from a surface, all pixels are the content.
std::string where(const WrongPixels& wrong, const ImageRule& rule, double content_share, const char* content)
{
    if (2 * wrong.outside <= wrong.all)
        return fmt::format("{:.3g} % of {}", 100 * content_share * (wrong.all - wrong.outside) / wrong.all, content);
    const double background = rule.places.background;
    if (!rule.places.is_plain) return fmt::format("{:.0f} of the {:.0f} pixels", wrong.all, background + rule.content);
    return fmt::format("{:.0f} of the {:.0f} pixels of the background", wrong.outside, background);
}

std::string bias_text(const ImageRule& rule)
{
    const ImagePlaces& places = rule.places;
    if (places.bias_at_edges)
        return fmt::format(
            "pixels at edges are too {} by {:.3g} levels of 255 on average: shapes are larger or smaller, lines wider "
            "or thinner, or edges smoothed otherwise",
            brightness(places.edge_bias), std::abs(places.edge_bias));
    return fmt::format("the picture is too {} by {:.3g} levels of 255 on average", brightness(places.bias),
                       std::abs(places.bias));
}

std::string cluster_text(const ImageRule& rule)
{
    const DensestWindow& cluster = rule.cluster;
    const char* what = "a small part has another colour";
    if (rule.places.is_plain && 2 * rule.places.cluster_holes > cluster.count)
        what = "a hole or a crack, through which the background is seen";
    else if (rule.places.is_plain && 2 * rule.places.cluster_extra > cluster.count)
        what = "something is drawn where the background should be";
    return fmt::format("{} wrong pixels lie close together at ({}, {}): {}", cluster.count, cluster.x + window_side / 2,
                       cluster.y + window_side / 2, what);
}

}

std::string complaint(const ImageRule& rule)
{
    // What is wrong everywhere is the thing to say; a single spot only where the rest is right.
    const auto everywhere = std::max_element(rule.ratios.begin(), rule.ratios.begin() + 4);
    const auto worst = *everywhere > 1 ? everywhere : std::max_element(rule.ratios.begin(), rule.ratios.end());
    const ImagePlaces& places = rule.places;
    switch (worst - rule.ratios.begin()) {
        case 0:
            return where(places.edges, rule, rule.edge_share, "the picture's content") +
                   (2 * places.edges.outside > places.edges.all ? " have no similar pixel next to their place"
                                                                : " has no similar pixel next to its place");
        case 1:
            return where(places.interior, rule, rule.interior_share, "the smooth surfaces") + " have another colour";
        case 2: return bias_text(rule);
        case 4: return cluster_text(rule);
        case 5:
            return fmt::format("round pixel ({}, {}) the surface is too {} by {:.3g} levels of 255",
                               rule.surface.x + window_side / 2, rule.surface.y + window_side / 2,
                               brightness(rule.surface.difference), std::abs(rule.surface.difference));
        case 6:
            return fmt::format("edges are displaced by {}: look at the sampling point, the pixel's centre",
                               offset_text(rule.displacement.x, rule.displacement.y));
        default: return fmt::format("everything is shifted by {}", offset_text(rule.shift_x, rule.shift_y));
    }
}

}
