#pragma once

#include <cmath>
#include <kit/color.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/lighting/color.hpp>
#include <vector>

/// Random lamps, light and pixels.
namespace umbral::lighting {

inline std::uint8_t random_code(Random& random) { return static_cast<std::uint8_t>(random.below(256)); }

inline std::vector<Lamp> random_lamps(Random& random, std::uint32_t count)
{
    std::vector<Lamp> lamps(count);
    for (Lamp& lamp : lamps) {
        lamp.color = 0.5F + 0.5F * random.in_cube();
        lamp.amount = random.uniform(0, 3);
    }
    return lamps;
}

/// Light whose code lies at least 0.1 away from the border to the next one, so that no rounding decides.
inline float clear_light(Random& random)
{
    const double code = random.below(255) + random.uniform_double() * 0.8 - 0.4;
    return static_cast<float>(srgb_decoded(std::abs(code) / 255));
}

inline glm::vec3 clear_color(Random& random)
{
    const float red = clear_light(random);
    const float green = clear_light(random);
    return {red, green, clear_light(random)};
}

inline glm::u8vec3 random_pixel(Random& random)
{
    const std::uint32_t bits = random.bits();
    return {bits >> 24U, bits >> 16U & 255U, bits >> 8U & 255U};
}

/// One to six of them; of three times one is out, but not the last, and another time one is black.
inline std::vector<Lamp> lamps_of_kind(Random& random, int kind)
{
    std::vector<Lamp> lamps = random_lamps(random, 1 + random.below(6));
    const std::size_t at = random.below(static_cast<std::uint32_t>(lamps.size() + 1) / 2);
    if (kind % 3 == 0) lamps[at].amount = 0;
    if (kind % 3 == 1) lamps[at].color = glm::vec3(0);
    return lamps;
}

/// Several, one of them black, or a single one, or some that begin and end with the same one.
inline std::vector<glm::u8vec3> pixels_of_kind(Random& random, int kind)
{
    std::vector<glm::u8vec3> pixels(kind % 4 == 1 ? 1 : 3 + random.below(3));
    for (glm::u8vec3& pixel : pixels) pixel = random_pixel(random);
    if (kind % 4 == 2) pixels[1] = glm::u8vec3(0);
    if (kind % 4 == 3) pixels.back() = pixels.front();
    return pixels;
}

/// Outside of 0 to 1, of eight kinds: by little, by much, by very much, without end; below and above.
inline float out_of_range_of_kind(Random& random, int kind)
{
    const float far = std::pow(10.0F, random.uniform(3, 38));
    switch (kind) {
        case 0: return -std::pow(10.0F, random.uniform(-8, -4));
        case 1: return -random.uniform(0.1F, 10);
        case 2: return -far;
        case 3: return -std::numeric_limits<float>::infinity();
        case 4: return 1 + std::pow(10.0F, random.uniform(-6, -3));
        case 5: return random.uniform(1.1F, 50);
        case 6: return far;
        default: return std::numeric_limits<float>::infinity();
    }
}

}
