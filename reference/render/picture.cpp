#include "render/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace umbral::render {
namespace {

/// Applies `color_of` to every cell.
template <class Cell, class ColorOf>
Image map(const Grid<Cell>& cells, const ColorOf& color_of)
{
    Image image(cells.width, cells.height);
    std::transform(cells.cells.begin(), cells.cells.end(), image.cells.begin(), color_of);
    return image;
}

glm::u8vec4 gray(float linear) { return glm::u8vec4(glm::u8vec3(to_srgb(linear)), 255); }

/// Neighbouring ids get hues far apart: steps by the golden ratio.
glm::u8vec4 color_of_id(std::uint32_t id)
{
    if (id == 0) return {0, 0, 0, 255};
    const double hue = 6 * std::fmod(id * 0.6180339887498949, 1.0);
    const auto channel = [&](double shift) {
        return static_cast<float>(std::clamp(std::abs(std::fmod(hue + shift, 6.0) - 3) - 1, 0.0, 1.0));
    };
    const glm::vec3 pure(channel(0), channel(4), channel(2));
    const glm::vec3 color = glm::mix(glm::vec3(0.75F), pure, 0.7F);
    return {to_srgb(color.r), to_srgb(color.g), to_srgb(color.b), 255};
}

}

double encoded(float linear)
{
    const double value = linear > 0 ? std::min(double{linear}, 1.0) : 0;
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

std::uint8_t to_srgb(float linear) { return static_cast<std::uint8_t>(std::lround(255 * encoded(linear))); }

Image make_picture(const Frame& frame, const scene::Scene& scene, int samples)
{
    if (samples < 1 || frame.width() % samples != 0 || frame.height() % samples != 0)
        throw std::invalid_argument("make_picture: expected sides that are multiples of the samples");
    Image image(frame.width() / samples, frame.height() / samples);
    for (int y = 0; y < image.height; ++y) {
        const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(image.height);
        const glm::vec3 background = glm::mix(scene.background_top, scene.background_bottom, down);
        for (int x = 0; x < image.width; ++x) {
            glm::vec3 sum(0);
            for (int i = 0; i < samples * samples; ++i) {
                const glm::vec4& color = frame.color.at(samples * x + i % samples, samples * y + i / samples);
                // Clamped before it is averaged: a highlight beyond white must not keep its edge jagged.
                const glm::vec3 drawn = glm::clamp(glm::vec3(color), 0.0F, 1.0F);
                sum += color.a >= 1 ? drawn : drawn + (1 - color.a) * background;
            }
            const glm::vec3 mean = sum / static_cast<float>(samples * samples);
            image.at(x, y) = {to_srgb(mean.r), to_srgb(mean.g), to_srgb(mean.b), 255};
        }
    }
    return image;
}

Image picture_of_depth(const Frame& frame)
{
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = -nearest;
    for (std::size_t i = 0; i < frame.ids.cells.size(); ++i) {
        if (frame.ids.cells[i] == 0) continue;
        nearest = std::min(nearest, frame.depth.cells[i]);
        farthest = std::max(farthest, frame.depth.cells[i]);
    }
    const float range = std::max(farthest - nearest, std::numeric_limits<float>::min());
    return map(frame.depth,
               [&](float depth) { return depth > farthest ? gray(0) : gray(1 - 0.97F * (depth - nearest) / range); });
}

Image picture_of_ids(const Frame& frame) { return map(frame.ids, color_of_id); }

Image picture_of_coverage(const Frame& frame)
{
    return map(frame.ids, [](std::uint32_t id) { return gray(id != 0 ? 1.0F : 0.0F); });
}

}
