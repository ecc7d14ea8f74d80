#include "judge/picture/image_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>

#include "judge/explain/thresholds.hpp"
#include "judge/picture/image_edges.hpp"

namespace umbral::grader {
namespace {

using Bytes = std::vector<std::uint8_t>;

// 1 where a pixel differs from the background by more than so many levels.
Bytes content_of(const Picture& picture, const std::array<std::uint8_t, 4>& background, int levels)
{
    const auto width = static_cast<std::size_t>(picture.width);
    Bytes content(width * static_cast<std::size_t>(picture.height), 0);
    for (int c = 0; c < picture.channels; ++c)
        for (int y = 0; y < picture.height; ++y) {
            const std::uint8_t* row = picture.row(c, y);
            std::uint8_t* out = content.data() + static_cast<std::size_t>(y) * width;
            const std::uint8_t base = background[static_cast<std::size_t>(c)];
            for (std::size_t x = 0; x < width; ++x)
                out[x] = static_cast<std::uint8_t>(out[x] | (apart(row[x], base) > levels ? 1 : 0));
        }
    return content;
}

// 1 where no channel spans more than smooth_span over the 3x3 neighbourhood.
Bytes smooth_part(const Picture& picture)
{
    const auto width = static_cast<std::size_t>(picture.width);
    Bytes smooth(width * static_cast<std::size_t>(picture.height), 1);
    Bytes low(width + 2);
    Bytes high(width + 2);
    for (int c = 0; c < picture.channels; ++c)
        for (int y = 0; y < picture.height; ++y) {
            const std::uint8_t* above = picture.row(c, y - 1) - 1;
            const std::uint8_t* here = picture.row(c, y) - 1;
            const std::uint8_t* below = picture.row(c, y + 1) - 1;
            for (std::size_t x = 0; x < width + 2; ++x) {
                low[x] = std::min(std::min(above[x], here[x]), below[x]);
                high[x] = std::max(std::max(above[x], here[x]), below[x]);
            }
            std::uint8_t* out = smooth.data() + static_cast<std::size_t>(y) * width;
            for (std::size_t x = 0; x < width; ++x) {
                const std::uint8_t bottom = std::min(std::min(low[x], low[x + 1]), low[x + 2]);
                const std::uint8_t top = std::max(std::max(high[x], high[x + 1]), high[x + 2]);
                out[x] = static_cast<std::uint8_t>(out[x] & (top - bottom <= thresholds::smooth_span ? 1 : 0));
            }
        }
    return smooth;
}

struct EdgeSums {
    double all = 0;        ///< what edge pixels that changed hands add to the sum of a channel's differences …
    double by_chance = 0;  ///< … and how much of it chance explains
};

// What edge pixels that changed hands, which (a) forgives, add: nothing as long as it is within three standard
// deviations of what chance gives. A line drawn too wide changes them all one way, and goes far beyond.
EdgeSums sums_of_edges(const Picture& student, const Picture& expected, int channel,
                       const std::vector<glm::ivec2>& forgiven)
{
    double sum = 0;
    double squares = 0;
    for (const glm::ivec2& at : forgiven) {
        const int moved = student.row(channel, at.y)[at.x] - expected.row(channel, at.y)[at.x];
        sum += moved;
        squares += moved * moved;
    }
    return {sum, std::copysign(std::min(std::abs(sum), 3 * std::sqrt(squares)), sum)};
}

// (c): the mean difference of the worst colour channel, and the mean level of the expected content.
void measure_bias(const Picture& student, const Picture& expected, const Bytes& either, const Bytes& content,
                  double area, const std::vector<glm::ivec2>& forgiven, ImageRule& rule)
{
    const auto width = static_cast<std::size_t>(expected.width);
    double level = 0;
    for (int c = 0; c < expected.colours(); ++c) {
        std::int64_t sum = 0;
        std::int64_t light = 0;
        for (int y = 0; y < expected.height; ++y) {
            const std::uint8_t* yours = student.row(c, y);
            const std::uint8_t* target = expected.row(c, y);
            const std::uint8_t* mask = either.data() + static_cast<std::size_t>(y) * width;
            const std::uint8_t* inside = content.data() + static_cast<std::size_t>(y) * width;
            int row_sum = 0;
            int row_light = 0;
            for (std::size_t x = 0; x < width; ++x) {
                row_sum += (yours[x] - target[x]) * mask[x];
                row_light += target[x] * inside[x];
            }
            sum += row_sum;
            light += row_light;
        }
        const EdgeSums edges = sums_of_edges(student, expected, c, forgiven);
        const double difference = static_cast<double>(sum) - edges.by_chance;
        if (const double bias = difference / area; std::abs(bias) > std::abs(rule.bias)) {
            rule.bias = bias;
            rule.places.bias_at_edges = 2 * (edges.all - edges.by_chance) / difference > 1;
            rule.places.edge_bias = edges.all / static_cast<double>(std::max<std::size_t>(forgiven.size(), 1));
        }
        level += static_cast<double>(light) / area / expected.colours();
    }
    rule.ratios[2] = std::abs(rule.bias) / std::max(thresholds::bias_levels, thresholds::bias_share * level);
}

// Does the background cover more than half of the border?
bool is_plain_border(const Bytes& content, std::size_t width, std::size_t height)
{
    std::size_t drawn = 0;
    for (std::size_t x = 0; x < width; ++x) drawn += content[x] + content[(height - 1) * width + x];
    for (std::size_t y = 0; y < height; ++y) drawn += content[y * width] + content[(y + 1) * width - 1];
    return drawn < width + height;
}

WrongPixels wrong_pixels(const Bytes& marks, const Bytes& content)
{
    std::size_t all = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        all += marks[i];
        inside += static_cast<std::size_t>(marks[i] & content[i]);
    }
    return {static_cast<double>(all), static_cast<double>(all - inside)};
}

// What the wrong pixels of (e) are; `drawn` is the content of the student's picture.
void look_into_cluster(const Bytes& errors, const Bytes& content, const Bytes& drawn, const Picture& expected,
                       ImageRule& rule)
{
    for (int y = rule.cluster.y; y < std::min(expected.height, rule.cluster.y + window_side); ++y)
        for (int x = rule.cluster.x; x < std::min(expected.width, rule.cluster.x + window_side); ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width) + static_cast<std::size_t>(x);
            rule.places.cluster_holes += errors[at] & content[at] & (drawn[at] ^ 1);
            rule.places.cluster_extra += errors[at] & (content[at] ^ 1);
        }
}

// Sum of differences if the expected picture is moved by (dx, dy), each -1, 0 or 1; beyond the edge lies the repeated
// border.
std::int64_t shifted_difference(const Picture& student, const Picture& expected, int dx, int dy)
{
    std::int64_t sum = 0;
    for (int c = 0; c < expected.colours(); ++c)
        for (int y = 0; y < expected.height; ++y) {
            const std::uint8_t* yours = student.row(c, y);
            const std::uint8_t* target = expected.row(c, y - dy) - dx;
            unsigned row_sum = 0;
            for (int x = 0; x < expected.width; ++x) row_sum += apart(yours[x], target[x]);
            sum += row_sum;
        }
    return sum;
}

void find_shift(const Picture& student, const Picture& expected, double area, ImageRule& rule)
{
    const std::int64_t still = shifted_difference(student, expected, 0, 0);
    if (static_cast<double>(still) <= thresholds::shift_minimum * area * expected.colours()) return;
    auto best = static_cast<double>(still) * thresholds::shift_gain;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const auto moved = static_cast<double>(shifted_difference(student, expected, dx, dy));
            if (moved >= best) continue;
            best = moved;
            rule.shift_x = dx;
            rule.shift_y = dy;
        }
    if (rule.shift_x != 0 || rule.shift_y != 0) rule.ratios[3] = thresholds::shift_ratio;
}

}

double ImageRule::worst() const { return *std::max_element(ratios.begin(), ratios.end()); }

double ImageRule::everywhere() const { return *std::max_element(ratios.begin(), ratios.begin() + 4); }

double ImageRule::right() const
{
    // What shows in one window only is a small fault, however clear it is.
    const double somewhere = std::min(*std::max_element(ratios.begin() + 4, ratios.end()), thresholds::window_ratio);
    const double ratio = std::max(everywhere(), somewhere);
    return ratio <= 1 ? 1.0 : std::max(0.0, 1 - std::log(ratio) / std::log(thresholds::zero_ratio));
}

std::array<std::uint8_t, 4> background_of(const Picture& picture)
{
    std::vector<std::array<std::uint8_t, 4>> border;
    const auto add = [&](int x, int y) {
        std::array<std::uint8_t, 4> colour{};
        for (int c = 0; c < picture.channels; ++c) colour[static_cast<std::size_t>(c)] = picture.row(c, y)[x];
        border.push_back(colour);
    };
    for (int x = 0; x < picture.width; ++x) add(x, 0), add(x, picture.height - 1);
    for (int y = 1; y + 1 < picture.height; ++y) add(0, y), add(picture.width - 1, y);
    std::sort(border.begin(), border.end());
    std::size_t most = 0;
    std::array<std::uint8_t, 4> best{};
    for (auto run = border.begin(); run != border.end();) {
        const auto end = std::upper_bound(run, border.end(), *run);
        if (const auto count = static_cast<std::size_t>(end - run); count > most) most = count, best = *run;
        run = end;
    }
    return best;
}

std::vector<std::uint8_t> channel_difference(const Picture& a, const Picture& b)
{
    const auto width = static_cast<std::size_t>(a.width);
    Bytes difference(width * static_cast<std::size_t>(a.height), 0);
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y) {
            const std::uint8_t* from = a.row(c, y);
            const std::uint8_t* to = b.row(c, y);
            std::uint8_t* out = difference.data() + static_cast<std::size_t>(y) * width;
            for (std::size_t x = 0; x < width; ++x) out[x] = std::max(out[x], apart(from[x], to[x]));
        }
    return difference;
}

ImageRule apply_image_rule(const Picture& student, const Picture& expected)
{
    const Bytes difference = channel_difference(student, expected);
    const auto background = background_of(expected);
    const Bytes content = content_of(expected, background, thresholds::background_levels);
    // Of the student's picture only what noise cannot lift off the background: else just the pixels that noise made
    // brighter would count.
    const Bytes drawn = content_of(student, background, thresholds::interior_levels);
    Bytes either = drawn;
    std::size_t expected_count = 0;
    std::size_t either_count = 0;
    for (std::size_t i = 0; i < content.size(); ++i) {
        either[i] = static_cast<std::uint8_t>(either[i] | content[i]);
        expected_count += content[i];
        either_count += either[i];
    }

    ImageRule rule;
    rule.content = static_cast<double>(expected_count);
    // An expected picture without content leaves only what the student drew.
    const double area =
        static_cast<double>(expected_count > 0 ? expected_count : std::max<std::size_t>(either_count, 1));
    const Bytes errors = edge_errors(student, expected, difference);
    rule.places.edges = wrong_pixels(errors, content);
    rule.edge_share = rule.places.edges.all / area;
    rule.ratios[0] = rule.edge_share / thresholds::edge_share;
    rule.cluster = densest_window(errors, expected.width, expected.height);
    rule.ratios[4] = rule.cluster.count / thresholds::cluster_pixels;
    look_into_cluster(errors, content, drawn, expected, rule);

    std::vector<glm::ivec2> forgiven;
    if (rule.ratios[0] <= 1)
        for (int y = 0; y < expected.height; ++y)
            for (int x = 0; x < expected.width; ++x)
                if (const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width) +
                                           static_cast<std::size_t>(x);
                    difference[at] > thresholds::edge_levels && errors[at] == 0 && either[at] != 0)
                    forgiven.emplace_back(x, y);

    const Bytes smooth = smooth_part(expected);
    std::size_t interior = 0;
    Bytes recoloured(content.size());
    for (std::size_t i = 0; i < content.size(); ++i) {
        interior += static_cast<std::size_t>(smooth[i] & content[i]);
        recoloured[i] = static_cast<std::uint8_t>(smooth[i] & (difference[i] > thresholds::interior_levels ? 1 : 0));
    }
    rule.places.interior = wrong_pixels(recoloured, content);
    rule.interior_share =
        rule.places.interior.all / std::max(static_cast<double>(interior), thresholds::smooth_floor * area);
    rule.ratios[1] = rule.interior_share / thresholds::interior_share;

    measure_bias(student, expected, either, content, area, forgiven, rule);
    rule.places.bias = rule.bias * area / static_cast<double>(std::max<std::size_t>(either_count, 1));
    rule.places.background = static_cast<double>(content.size()) - rule.content;
    rule.places.is_plain = is_plain_border(content, static_cast<std::size_t>(expected.width),
                                           content.size() / static_cast<std::size_t>(expected.width));
    find_shift(student, expected, area, rule);
    if (rule.everywhere() >= thresholds::window_ratio) return rule;
    Bytes surface(smooth.size());
    // What is wrong by (a) is counted there.
    for (std::size_t i = 0; i < content.size(); ++i)
        surface[i] = static_cast<std::uint8_t>(smooth[i] & (errors[i] ^ 1U));
    rule.surface = worst_level_window(student, expected, surface);
    rule.ratios[5] = rule.surface.ratio;
    // Edges that move change some pixel by more than noise does.
    if (*std::max_element(difference.begin(), difference.end()) <= thresholds::interior_levels) return rule;
    rule.displacement = edge_displacement(student, expected, smooth);
    rule.ratios[6] = std::hypot(rule.displacement.x, rule.displacement.y) / thresholds::displacement;
    return rule;
}

}
