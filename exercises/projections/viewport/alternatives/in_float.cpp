// alternative: float, but for the search of pixels and for depths, which may be as large as floats are
#include <umbral/projections/viewport.hpp>

namespace umbral::projections {

glm::mat4 viewport_matrix(const Viewport& v)
{
    const float w = static_cast<float>(v.width) / 2;
    const float h = static_cast<float>(v.height) / 2;
    const float d = v.far_depth / 2 - v.near_depth / 2;
    return {w,
            0,
            0,
            0,
            0,
            h,
            0,
            0,
            0,
            0,
            d,
            0,
            static_cast<float>(v.left) + w,
            static_cast<float>(v.bottom) + h,
            v.near_depth / 2 + v.far_depth / 2,
            1};
}

glm::vec3 ndc_from_window(const Viewport& v, const glm::vec3& window)
{
    return {2 * (window.x - static_cast<float>(v.left)) / static_cast<float>(v.width) - 1,
            2 * (window.y - static_cast<float>(v.bottom)) / static_cast<float>(v.height) - 1,
            static_cast<float>(2 * (double{window.z} - v.near_depth) / (double{v.far_depth} - v.near_depth) - 1)};
}

std::optional<glm::ivec2> pixel_at(const Viewport& v, const glm::vec2& ndc)
{
    const auto is_in = [](float x) { return x >= -1 && x < 1; };
    if (!is_in(ndc.x) || !is_in(ndc.y)) return std::nullopt;
    return glm::ivec2(v.left + static_cast<int>((1 + double{ndc.x}) / 2 * v.width),
                      v.bottom + static_cast<int>((1 + double{ndc.y}) / 2 * v.height));
}

glm::vec2 pixel_centre(const Viewport& v, const glm::ivec2& pixel)
{
    const glm::vec2 inside = glm::vec2(pixel - glm::ivec2(v.left, v.bottom)) + 0.5F;
    return 2.0F * inside / glm::vec2(v.width, v.height) - 1.0F;
}

}
