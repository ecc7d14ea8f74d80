#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <umbral/core/grid.hpp>
#include <utility>
#include <vector>

#include "color.hpp"

/// Diagrams for the goal pictures of units whose answers are numbers: smooth lines, discs, arrows and areas over a
/// grid.
namespace umbral {

/// A picture of a rectangle of the plane, y up. Places are in the plane's units; widths and radii are in pixels.
///
/// What is drawn later lies on top. Places that are not finite draw nothing: a student's NaN must not stop a picture.
class Drawing {
public:
    /// `low` and `high` are opposite corners of the rectangle; one that is narrower or flatter than the picture is
    /// centred in it.
    Drawing(int width, int height, glm::dvec2 low, glm::dvec2 high, glm::vec3 background = ink::night)
        : pixels_(width, height, srgb_decoded(background)),
          middle_(0.5 * (low + high)),
          scale_(std::min(width / (high.x - low.x), height / (high.y - low.y)))
    {
    }

    void line(glm::dvec2 from, glm::dvec2 to, glm::vec3 color, double width = 2, double alpha = 1)
    {
        const glm::dvec2 a = to_pixels(from);
        const glm::dvec2 along = to_pixels(to) - a;
        if (!is_drawable(a) || !is_drawable(a + along)) return;
        const double length_squared = glm::dot(along, along);
        // In a row, all that is nearer than `reach` to the line through both places.
        const double reach = 0.5 * width + 1;
        const auto near_line = [&](double y) {
            if (along.y == 0) return everywhere;
            const double x = a.x + (y - a.y) / along.y * along.x;
            const double half = reach * std::sqrt(length_squared) / std::abs(along.y);
            return Range{x - half, x + half};
        };
        paint(glm::min(a, a + along) - 0.5 * width, glm::max(a, a + along) + 0.5 * width, color, alpha, near_line,
              [&](glm::dvec2 p) {
                  const double t =
                      length_squared > 0 ? std::clamp(glm::dot(p - a, along) / length_squared, 0.0, 1.0) : 0.0;
                  return smooth(0.5 * width - glm::length(p - a - t * along));
              });
    }

    /// A line with a head at `to`.
    void arrow(glm::dvec2 from, glm::dvec2 to, glm::vec3 color, double width = 2.5)
    {
        const double length = scale_ * glm::length(to - from);
        if (!(length > 0)) return;
        const glm::dvec2 back = (from - to) / length * std::min(length, 5 * width);
        const glm::dvec2 aside = 0.45 * glm::dvec2(-back.y, back.x);
        line(from, to + 0.8 * back, color, width);
        area(std::vector<glm::dvec2>{to, to + back + aside, to + back - aside}, color);
    }

    /// The closed line through these places.
    void outline(std::span<const glm::dvec2> places, glm::vec3 color, double width = 2)
    {
        for (std::size_t i = 0; i < places.size(); ++i) line(places[i], places[(i + 1) % places.size()], color, width);
    }

    void disc(glm::dvec2 place, double radius, glm::vec3 color, double alpha = 1)
    {
        const glm::dvec2 middle = to_pixels(place);
        paint(middle - radius, middle + radius, color, alpha, whole_row,
              [&](glm::dvec2 p) { return smooth(radius - glm::length(p - middle)); });
    }

    void ring(glm::dvec2 place, double radius, glm::vec3 color, double width = 2)
    {
        const glm::dvec2 middle = to_pixels(place);
        const double outside = radius + 0.5 * width;
        paint(middle - outside, middle + outside, color, 1, whole_row,
              [&](glm::dvec2 p) { return smooth(0.5 * width - std::abs(glm::length(p - middle) - radius)); });
    }

    /// The inside of a polygon of any shape, by the even-odd rule.
    void area(std::span<const glm::dvec2> places, glm::vec3 color, double alpha = 1)
    {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec2& place : places) corners.push_back(to_pixels(place));
        if (corners.empty() || !std::all_of(corners.begin(), corners.end(), is_drawable)) return;
        glm::dvec2 low = corners.front();
        glm::dvec2 high = low;
        for (const glm::dvec2& corner : corners) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        // Where the sides cross four lines in each row of pixels, which have four samples in each pixel.
        constexpr int samples = 4;
        std::array<std::vector<double>, samples> crossings;
        const auto cross_row = [&](double y) {
            for (int i = 0; i < samples; ++i)
                crossings_at(corners, y + i / double(samples) - 0.375, crossings[static_cast<std::size_t>(i)]);
            return everywhere;
        };
        paint(low, high, color, alpha, cross_row, [&](glm::dvec2 p) {
            std::ptrdiff_t inside = 0;
            for (const std::vector<double>& line : crossings)
                for (int i = 0; i < samples; ++i) {
                    const double x = p.x + i / double(samples) - 0.375;
                    inside += (line.end() - std::upper_bound(line.begin(), line.end(), x)) % 2;
                }
            return static_cast<double>(inside) / double(samples * samples);
        });
    }

    /// Faint lines at the multiples of `step`, and brighter ones through the origin.
    void grid(double step, glm::vec3 color = ink::slate)
    {
        const glm::dvec2 half = 0.5 * glm::dvec2(pixels_.width, pixels_.height) / scale_;
        const glm::dvec2 low = middle_ - half;
        const glm::dvec2 high = middle_ + half;
        const auto lines = [&](double first, double last, auto draw) {
            for (double k = std::ceil(first / step); k <= last / step; ++k) draw(k * step, k == 0 ? 2.0 : 1.0);
        };
        lines(low.x, high.x, [&](double x, double width) { line({x, low.y}, {x, high.y}, color, width); });
        lines(low.y, high.y, [&](double y, double width) { line({low.x, y}, {high.x, y}, color, width); });
    }

    [[nodiscard]] Image picture() const
    {
        Image result(pixels_.width, pixels_.height);
        // Most pixels have the colour of the one before, and the sRGB curve takes longest of all.
        std::optional<glm::dvec3> before;
        glm::u8vec4 pixel;
        std::transform(pixels_.cells.begin(), pixels_.cells.end(), result.cells.begin(), [&](const glm::dvec3& light) {
            if (before != light) {
                pixel = pixel_of(light);
                before = light;
            }
            return pixel;
        });
        return result;
    }

private:
    static bool is_drawable(glm::dvec2 p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; }
    static double smooth(double depth) { return std::clamp(depth + 0.5, 0.0, 1.0); }

    [[nodiscard]] glm::dvec2 to_pixels(glm::dvec2 place) const
    {
        const glm::dvec2 shift = scale_ * (place - middle_);
        return {0.5 * pixels_.width + shift.x, 0.5 * pixels_.height - shift.y};
    }

    /// Places of a row between which a shape lies, in pixels from the left.
    struct Range {
        double first;
        double last;
    };
    static constexpr Range everywhere{-1e6, 1e6};
    static Range whole_row(double) { return everywhere; }

    /// Where the sides of a polygon cross the line at this height, from left to right: a place with an odd number of
    /// them to its right is inside.
    static void crossings_at(const std::vector<glm::dvec2>& corners, double y, std::vector<double>& crossings)
    {
        crossings.clear();
        for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
            const glm::dvec2& a = corners[i];
            const glm::dvec2& b = corners[j];
            if ((a.y > y) != (b.y > y)) crossings.push_back((b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x);
        }
        std::sort(crossings.begin(), crossings.end());
    }

    // Mixes `color` into the pixels of a box. `row` is told the height of each row's middle and answers in which range
    // there is anything to paint; `cover` gives how much of the pixel round a place is covered.
    template <class Row, class Cover>
    void paint(glm::dvec2 low, glm::dvec2 high, glm::vec3 color, double alpha, Row row, Cover cover)
    {
        if (!is_drawable(low) || !is_drawable(high)) return;
        const glm::dvec3 paint = srgb_decoded(color);
        const int bottom = std::min(pixels_.height - 1, static_cast<int>(std::ceil(high.y)));
        for (int y = std::max(0, static_cast<int>(std::floor(low.y)) - 1); y <= bottom; ++y) {
            const Range range = row(y + 0.5);
            const double left = std::max(low.x, range.first);
            const double right = std::min(high.x, range.last);
            if (!(left <= right + 1)) continue;
            const int last = std::min(pixels_.width - 1, static_cast<int>(std::ceil(right)));
            for (int x = std::max(0, static_cast<int>(std::floor(left)) - 1); x <= last; ++x) {
                glm::dvec3& pixel = pixels_.at(x, y);
                pixel = glm::mix(pixel, paint, alpha * cover(glm::dvec2(x + 0.5, y + 0.5)));
            }
        }
    }

    Grid<glm::dvec3> pixels_;
    glm::dvec2 middle_;
    double scale_;
};

}
