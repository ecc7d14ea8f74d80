#include "render/compare.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace umbral::render {
namespace {

bool is_interior(const Frame& first, const Frame& second, int x, int y)
{
    const std::uint32_t id = first.ids.at(x, y);
    if (id == 0) return false;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (first.ids.contains(x + dx, y + dy) &&
                (first.ids.at(x + dx, y + dy) != id || second.ids.at(x + dx, y + dy) != id))
                return false;
    return true;
}

// As to_srgb in picture.hpp, without its rounding: that would make steps of differences that are none.
double srgb_steps(float linear)
{
    const double value = linear > 0 ? std::min(double{linear}, 1.0) : 0;
    return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
}

bool at_most(std::size_t count, double fraction, std::size_t of)
{
    return static_cast<double>(count) <= std::ceil(fraction * static_cast<double>(of));
}

}

Comparison compare(const Frame& first, const Frame& second, const Agreement& agreement)
{
    if (first.width() != second.width() || first.height() != second.height())
        throw std::invalid_argument("compare: expected frames of one size");
    Comparison result;
    result.pixels = first.ids.cells.size();
    double squares = 0;
    double edge_squares = 0;
    std::size_t edges = 0;
    double color_sum = 0;
    double depth_sum = 0;
    for (int y = 0; y < first.height(); ++y) {
        for (int x = 0; x < first.width(); ++x) {
            const std::uint32_t a = first.ids.at(x, y);
            const std::uint32_t b = second.ids.at(x, y);
            result.covered_first += a != 0 ? 1 : 0;
            result.covered_second += b != 0 ? 1 : 0;
            result.coverage_differs += (a != 0) != (b != 0) ? 1 : 0;
            result.ids_differ += a != b ? 1 : 0;
            const bool interior = is_interior(first, second, x, y);
            const bool edge = !interior && (a != 0 || b != 0);
            edges += edge ? 1 : 0;
            double largest = 0;
            for (int channel = 0; channel < 3; ++channel) {
                const double difference =
                    std::abs(srgb_steps(first.color.at(x, y)[channel]) - srgb_steps(second.color.at(x, y)[channel]));
                squares += difference * difference;
                edge_squares += edge ? difference * difference : 0;
                if (!interior) continue;
                color_sum += difference;
                largest = std::max(largest, difference);
            }
            if (!interior) continue;
            ++result.interior;
            result.color_max = std::max(result.color_max, largest);
            result.color_beyond += largest > agreement.color ? 1 : 0;
            const double depth = std::abs(double{first.depth.at(x, y)} - double{second.depth.at(x, y)});
            result.depth_max = std::max(result.depth_max, depth);
            depth_sum += depth;
        }
    }
    const double interior = std::max<double>(1, static_cast<double>(result.interior));
    result.color_mean = color_sum / (3 * interior);
    result.depth_mean = depth_sum / interior;
    result.color_edge_rmse = edges > 0 ? std::sqrt(edge_squares / (3 * static_cast<double>(edges))) : 0;
    result.color_rmse = result.pixels > 0 ? std::sqrt(squares / (3 * static_cast<double>(result.pixels))) : 0;
    return result;
}

NormalComparison compare_normals(const Grid<glm::vec3>& first_normals, const Grid<glm::vec3>& second_normals,
                                 const Frame& first, const Frame& second)
{
    NormalComparison result;
    std::size_t pixels = 0;
    for (int y = 0; y < first.height(); ++y) {
        for (int x = 0; x < first.width(); ++x) {
            if (!is_interior(first, second, x, y)) continue;
            const glm::dvec3 a(first_normals.at(x, y));
            const glm::dvec3 b(second_normals.at(x, y));
            const double angle = glm::degrees(std::atan2(length(cross(a, b)), dot(a, b)));
            result.largest = std::max(result.largest, angle);
            result.mean += angle;
            ++pixels;
        }
    }
    result.mean /= std::max<double>(1, static_cast<double>(pixels));
    return result;
}

bool agrees_in_shape(const Comparison& comparison, const Agreement& agreement)
{
    return at_most(comparison.ids_differ, agreement.edge_fraction, comparison.pixels) &&
           comparison.depth_max <= agreement.depth_most && comparison.depth_mean <= agreement.depth_mean;
}

bool agrees(const Comparison& comparison, const Agreement& agreement)
{
    return agrees_in_shape(comparison, agreement) &&
           at_most(comparison.color_beyond, agreement.color_fraction, comparison.interior);
}

}
