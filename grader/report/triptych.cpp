#include "report/triptych.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "judge/picture/colour_map.hpp"
#include "judge/picture/image_difference.hpp"
#include "judge/picture/picture.hpp"
#include "report/font.hpp"

namespace umbral::grader {
namespace {

constexpr int space = 16;
constexpr int label_height = 2 * letter_height + 10;  // at scale 2, with room below
constexpr int small_label_height = letter_height + 8;
constexpr int legend_height = 10;
constexpr int least_panel = 256;
constexpr int most_panel = 1280;
constexpr int zoom = 8;
constexpr glm::u8vec4 ground(250, 250, 248, 255);
constexpr glm::u8vec4 ink(40, 40, 44, 255);
constexpr glm::u8vec4 frame_light(255, 255, 255, 255);
constexpr glm::u8vec4 frame_dark(20, 110, 190, 255);

/// How a picture is shown: every pixel `enlarge` times as wide, or only one in `thin` of each direction.
struct View {
    int enlarge = 1;
    int thin = 1;

    [[nodiscard]] int shown(int size) const { return (size + thin - 1) / thin * enlarge; }
};

View view_for(int width, int height)
{
    const int size = std::max({width, height, 1});
    return {std::max(1, least_panel / size), (size + most_panel - 1) / most_panel};
}

glm::u8vec4 over_checkers(glm::u8vec4 colour, int x, int y)
{
    const unsigned back = (x / 8 + y / 8) % 2 == 0 ? 210 : 180;
    const auto mix = [&](unsigned value) {
        return static_cast<glm::u8>((value * colour.a + back * (255U - colour.a) + 127U) / 255U);
    };
    return {mix(colour.r), mix(colour.g), mix(colour.b), 255};
}

void fill(Image& image, const Window& area, glm::u8vec4 colour)
{
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x)
            if (image.contains(x, y)) image.at(x, y) = colour;
}

void outline(Image& image, const Window& area, glm::u8vec4 colour)
{
    fill(image, {area.x, area.y, area.width, 1}, colour);
    fill(image, {area.x, area.y + area.height - 1, area.width, 1}, colour);
    fill(image, {area.x, area.y, 1, area.height}, colour);
    fill(image, {area.x + area.width - 1, area.y, 1, area.height}, colour);
}

/// A light line within a dark one: visible on any picture, and outside the region so as not to cover it.
void frame(Image& image, const Window& area)
{
    outline(image, {area.x - 1, area.y - 1, area.width + 2, area.height + 2}, frame_light);
    outline(image, {area.x - 2, area.y - 2, area.width + 4, area.height + 4}, frame_dark);
    outline(image, {area.x - 3, area.y - 3, area.width + 6, area.height + 6}, frame_dark);
}

/// Draws `part` of a picture whose pixels `colour(x, y)` gives.
template <class Colour>
void draw(Image& target, int left, int top, const Window& part, const View& view, Colour colour)
{
    for (int y = 0; y < view.shown(part.height); ++y)
        for (int x = 0; x < view.shown(part.width); ++x)
            target.at(left + x, top + y) = over_checkers(
                colour(part.x + x / view.enlarge * view.thin, part.y + y / view.enlarge * view.thin), x, y);
}

/// The pictures' difference, its largest level, and where it is worst.
struct Comparison {
    Grid<std::uint8_t> map;
    int largest = 0;
    std::optional<WorstRegion> worst;
};

Comparison compare(const Image& yours, const Image& reference, const JudgeKind& judge)
{
    Check check;
    check.name = "triptych";
    check.judge = judge;
    const Tensor left = as_tensor(yours);
    const Tensor right = as_tensor(reference);
    Comparison comparison{difference_map(check, left, right), 0, worst_region(check, left, right)};
    for (const std::uint8_t level : comparison.map.cells) comparison.largest = std::max<int>(comparison.largest, level);
    return comparison;
}

glm::u8vec4 difference_colour(const Comparison& comparison, int x, int y, int block)
{
    int level = 0;
    for (int j = y; j < std::min(y + block, comparison.map.height); ++j)
        for (int i = x; i < std::min(x + block, comparison.map.width); ++i)
            level = std::max<int>(level, comparison.map.at(i, j));
    return magma(comparison.largest == 0 ? 0 : static_cast<double>(level) / comparison.largest);
}

void draw_legend(Image& target, int left, int top, int width, int largest)
{
    for (int x = 0; x < width; ++x)
        fill(target, {left + x, top, 1, legend_height}, magma(static_cast<double>(x) / std::max(1, width - 1)));
    const std::string most = fmt::format("{} of 255", largest);
    draw_text(target, left, top + legend_height + 4, "0", ink);
    draw_text(target, left + width - text_width(most, 1), top + legend_height + 4, most, ink);
}

/// In large letters where there is room for them.
void draw_label(Image& target, int left, int top, std::string_view text, int room = most_panel)
{
    draw_text(target, left, top, text, ink, text_width(text, 2) <= room ? 2 : 1);
}

/// The two pictures and, for want of a difference, a sentence.
Image uncomparable(const Image& yours, const Image& reference, std::string_view expected_side)
{
    const std::array pictures = {&yours, &reference};
    const std::array<std::string_view, 2> names = {"yours", expected_side};
    int height = 0;
    std::array<int, 2> widths{};
    for (std::size_t i = 0; i < 2; ++i) {
        const View view = view_for(pictures[i]->width, pictures[i]->height);
        widths[i] = std::max(least_panel, view.shown(pictures[i]->width));
        height = std::max(height, view.shown(pictures[i]->height));
    }
    Image result(std::max(4 * space + widths[0] + widths[1] - space, 600),
                 3 * space + 2 * label_height + small_label_height + height, ground);
    int left = space;
    for (std::size_t i = 0; i < 2; ++i) {
        const Image& picture = *pictures[i];
        draw_label(result, left, space, names[i], widths[i]);
        const std::string size =
            picture.cells.empty() ? "no picture" : fmt::format("{} x {}", picture.width, picture.height);
        draw_text(result, left, space + label_height, size, ink);
        draw(result, left, space + label_height + small_label_height, {0, 0, picture.width, picture.height},
             view_for(picture.width, picture.height), [&](int x, int y) { return picture.at(x, y); });
        left += widths[i] + space;
    }
    const bool empty = yours.cells.empty() || reference.cells.empty();
    draw_label(result, space, result.height - space - label_height + 10,
               empty ? "Nothing to compare: a picture is missing." : "The sizes differ: not compared.");
    return result;
}

}

Image triptych(const Image& yours, const Image& reference, std::string_view expected_side, const JudgeKind& judge)
{
    if (yours.width != reference.width || yours.height != reference.height || yours.cells.empty())
        return uncomparable(yours, reference, expected_side);
    const Comparison comparison = compare(yours, reference, judge);
    const View view = view_for(yours.width, yours.height);
    const Window whole{0, 0, yours.width, yours.height};
    const Window worst = comparison.worst ? comparison.worst->worst : Window{};
    const int panel = std::max({view.shown(yours.width), zoom * worst.width, least_panel});
    const int picture_height = view.shown(yours.height);
    const int pictures_top = space + label_height;
    const int legend_top = pictures_top + picture_height + 6;
    const int zoom_label_top = legend_top + legend_height + small_label_height + space;
    const int zoom_top = zoom_label_top + label_height;
    const int bottom = comparison.worst ? zoom_top + zoom * worst.height : zoom_label_top + 2 * letter_height;

    Image result(4 * space + 3 * panel, bottom + space, ground);
    const View zoomed{zoom, 1};
    const auto panel_of = [&](int index, std::string_view name, auto colour, int block) {
        const int left = space + index * (panel + space);
        draw_label(result, left, space, name, panel);
        draw(result, left, pictures_top, whole, view, [&](int x, int y) { return colour(x, y, block); });
        if (!comparison.worst) return;
        const auto place = [&](int at) { return at / view.thin * view.enlarge; };
        frame(result, {left + place(worst.x), pictures_top + place(worst.y), view.shown(worst.width),
                       view.shown(worst.height)});
        draw(result, left, zoom_top, worst, zoomed, [&](int x, int y) { return colour(x, y, 1); });
        frame(result, {left, zoom_top, zoom * worst.width, zoom * worst.height});
    };
    panel_of(
        0, "yours", [&](int x, int y, int) { return yours.at(x, y); }, view.thin);
    panel_of(
        1, expected_side, [&](int x, int y, int) { return reference.at(x, y); }, view.thin);
    panel_of(
        2, "difference", [&](int x, int y, int block) { return difference_colour(comparison, x, y, block); },
        view.thin);

    const std::string caption = comparison.worst ? fmt::format("worst region, {} times: {} x {} pixels from ({}, {})",
                                                               zoom, worst.width, worst.height, worst.x, worst.y)
                                                 : "the pictures are equal";
    draw_label(result, space, zoom_label_top, caption);
    if (comparison.worst)
        draw_legend(result, space + 2 * (panel + space), legend_top, view.shown(yours.width), comparison.largest);
    return result;
}

}
