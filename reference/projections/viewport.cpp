// Based on: the course's viewport matrix D = Tra[xl, yb, nd] · Esc[w, h, fd - nd] · Esc[1/2] · Tra[1, 1, 1].

#include <umbral/projections/viewport.hpp>

#include <cmath>

namespace umbral::projections {
namespace {

// In whole numbers and double: the sum ndc + 1 of floats would round what is just below 1 up to 2.
std::optional<int> cell(double ndc, int first, int count)
{
    if (!(ndc >= -1 && ndc < 1)) return std::nullopt;
    return first + static_cast<int>(std::floor((ndc + 1) * count / 2));
}

// The middle of a cell is an odd number of halves from the border.
float middle(int cell, int first, int count)
{
    return static_cast<float>(double(2 * (cell - first) + 1 - count) / count);
}

}

glm::mat4 viewport_matrix(const Viewport& viewport)
{
    const glm::dvec3 low(viewport.left, viewport.bottom, viewport.near_depth);
    const glm::dvec3 half = 0.5 * glm::dvec3(viewport.width, viewport.height, double{viewport.far_depth} - low.z);
    glm::mat4 matrix(1);
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = static_cast<float>(half[axis]);
    matrix[3] = glm::vec4(low + half, 1);
    return matrix;
}

glm::vec3 ndc_from_window(const Viewport& viewport, const glm::vec3& window)
{
    const glm::dvec3 low(viewport.left, viewport.bottom, viewport.near_depth);
    const glm::dvec3 size(viewport.width, viewport.height, double{viewport.far_depth} - low.z);
    return glm::vec3(2.0 * (glm::dvec3(window) - low) / size - 1.0);
}

std::optional<glm::ivec2> pixel_at(const Viewport& viewport, const glm::vec2& ndc)
{
    const std::optional<int> column = cell(ndc.x, viewport.left, viewport.width);
    const std::optional<int> row = cell(ndc.y, viewport.bottom, viewport.height);
    if (!column || !row) return std::nullopt;
    return glm::ivec2(*column, *row);
}

glm::vec2 pixel_centre(const Viewport& viewport, const glm::ivec2& pixel)
{
    return {middle(pixel.x, viewport.left, viewport.width), middle(pixel.y, viewport.bottom, viewport.height)};
}

}
