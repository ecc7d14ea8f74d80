#pragma once

#include <algorithm>
#include <cmath>
#include <kit/picture.hpp>
#include <numbers>
#include <umbral/core/grid.hpp>

/// Points of light on a long exposure: pictures of what happened in a window in the course of time.
namespace umbral::interaction {

inline constexpr int exposure_size = 240;
inline constexpr glm::dvec2 exposure_middle(0.5 * exposure_size);

class Exposure {
public:
    Exposure() : light_(exposure_size, exposure_size) {}

    /// A point of light with its halo, at a place in screen coordinates.
    void add(glm::dvec2 place, const glm::dvec3& color)
    {
        constexpr double reach = 22;
        if (!(glm::length(place) < 1e4)) return;
        const glm::ivec2 low = glm::max(glm::ivec2(place - reach), 0);
        const glm::ivec2 high = glm::min(glm::ivec2(place + reach), exposure_size - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 away = glm::dvec2(x + 0.5, y + 0.5) - place;
                const double square = glm::dot(away, away);
                const double halo = std::max(0.0, 1 - square / (reach * reach));
                light_.at(x, y) +=
                    color * (1.4 * std::exp(-square / 3.2) + 0.16 * std::exp(-square / 26) + 0.016 * halo * halo);
            }
    }

    /// The developed picture, brightest places saturated softly, in a corner of a wider one.
    void develop(Image& picture, int left) const
    {
        constexpr glm::dvec3 night(0.0030, 0.0036, 0.0075);
        for (int y = 0; y < exposure_size; ++y)
            for (int x = 0; x < exposure_size; ++x)
                picture.at(left + x, y) = pixel_of(1.0 - glm::exp(-(light_.at(x, y) + night)));
    }

private:
    Grid<glm::dvec3> light_;
};

inline glm::dvec3 light_color(double hue)
{
    return srgb_decoded(glm::dvec3(rainbow(static_cast<float>(hue), 0.72F, 1)));
}

inline glm::dvec2 on_circle(double turns)
{
    return {std::cos(2 * std::numbers::pi * turns), -std::sin(2 * std::numbers::pi * turns)};
}

}
