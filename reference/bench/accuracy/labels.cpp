#include "labels.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace umbral::bench {
namespace {

constexpr double line_height = 15;
constexpr double ascent = 10;
constexpr double descent = 3;

bool overlap(const Box& a, const Box& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Box box_of(const Place& place, double width) { return {place.x, place.y - ascent, place.x + width, place.y + descent}; }

}

double text_width(std::string_view text)
{
    // Bytes that continue a UTF-8 character take no room of their own.
    return 6.7 * static_cast<double>(std::count_if(
                     text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

bool Labels::is_free(const Box& box) const
{
    if (box.left < inside_.left || box.right > inside_.right || box.top < inside_.top || box.bottom > inside_.bottom)
        return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return overlap(box, other); });
}

void Labels::keep_free(double x, double y, double radius)
{
    taken_.push_back({x - radius, y - radius, x + radius, y + radius});
}

std::optional<Place> Labels::beside(double x, double y, const std::string& text, bool always)
{
    const double width = text_width(text);
    const double gap = always ? 14 : 9;
    const std::array places = {
        Place{x + gap, y - 5},         Place{x + gap, y + 4},          Place{x - width / 2, y - gap - 4},
        Place{x - gap - width, y - 5}, Place{x + 4, y + gap + ascent}, Place{x - gap - width, y + gap + 2}};
    for (const Place& place : places) {
        if (!is_free(box_of(place, width))) continue;
        taken_.push_back(box_of(place, width));
        return place;
    }
    if (!always) return std::nullopt;
    taken_.push_back(box_of(places[0], width));
    return places[0];
}

std::vector<Place> Labels::name_ends(const std::vector<NamedEnd>& ends, bool at_left)
{
    std::vector<std::size_t> order(ends.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ends[a].y < ends[b].y; });
    // Downwards each keeps its distance from the one above; what falls out of the picture is pushed up again.
    std::vector<double> heights(ends.size());
    double above = inside_.top - line_height + ascent;
    for (const std::size_t i : order) above = heights[i] = std::max(ends[i].y + 4, above + line_height);
    double below = inside_.bottom - descent + line_height;
    for (auto i = order.rbegin(); i != order.rend(); ++i)
        below = heights[*i] = std::min(heights[*i], below - line_height);
    std::vector<Place> places;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const double width = text_width(ends[i].name);
        places.push_back({at_left ? ends[i].x - 12 - width : ends[i].x + 12, heights[i]});
        taken_.push_back(box_of(places.back(), width));
    }
    return places;
}

}
