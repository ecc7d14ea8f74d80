#pragma once

#include <algorithm>
#include <array>
#include <kit/color.hpp>
#include <umbral/core/grid.hpp>

/// The arrow of a mouse in pictures, for the units that pick.
namespace umbral::interaction {

/// Draws a white arrow with a dark border; `tip` in pixels from the upper left corner, `size` its height in pixels.
inline void paint_arrow(Image& picture, const glm::vec2& tip, float size)
{
    constexpr std::array<glm::vec2, 7> corners = {
        {{0, 0}, {0, 17}, {3.9F, 13.4F}, {6.6F, 19.4F}, {9.2F, 18.2F}, {6.5F, 12.4F}, {12, 12}}};
    const auto shade_at = [&](const glm::vec2& place) {
        bool inside = false;
        float to_border = 100;
        for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
            const glm::vec2 a = corners[i];
            const glm::vec2 along = corners[j] - a;
            if ((a.y > place.y) != (corners[j].y > place.y) && place.x < a.x + along.x * (place.y - a.y) / along.y)
                inside = !inside;
            const float share = glm::clamp(dot(place - a, along) / dot(along, along), 0.0F, 1.0F);
            to_border = std::min(to_border, length(place - a - share * along));
        }
        return to_border < 1 ? glm::vec2(0.01F, 1) : glm::vec2(0.95F, inside ? 1 : 0);
    };
    constexpr int samples = 4;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec2 corner = (glm::vec2(x, y) - tip) * (19.4F / size);
            if (corner.x < -4 || corner.y < -4 || corner.x > 15 || corner.y > 23) continue;
            const glm::dvec3 behind = srgb_decoded(glm::dvec3(picture.at(x, y)) / 255.0);
            glm::dvec3 light(0);
            for (int k = 0; k < samples * samples; ++k) {
                const glm::vec2 aside = (glm::vec2(k % samples, k / samples) + 0.5F) / static_cast<float>(samples);
                const glm::vec2 shade = shade_at(corner + aside * (19.4F / size));
                light += shade.y > 0 ? glm::dvec3(shade.x) : behind;
            }
            picture.at(x, y) = pixel_of(light / double{samples * samples});
        }
}

}
