#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <umbral/core/random.hpp>
#include <vector>

#include "make.hpp"

namespace umbral::grader::test {

/// One random estimate with mean 1.
using Noise = double (*)(Random&);

/// As skewed as rare bright paths are: a standard deviation of its mean.
inline double exponential(Random& random) { return -std::log1p(-random.uniform_double()); }
/// A smooth integrand: 0.58 of its mean.
inline double uniform(Random& random) { return 2 * random.uniform_double(); }
/// Light seen once in two: its mean.
inline double visible(Random& random) { return random.below(2) * 2.0; }
/// Fireflies: a log-normal one whose standard deviation is 2.9 of its mean.
inline double firefly(Random& random)
{
    const double radius = std::sqrt(-2 * std::log1p(-random.uniform_double()));
    const double normal = radius * std::cos(6.283185307179586 * random.uniform_double());
    return std::exp(1.5 * normal - 1.125);
}

inline double mean_of(Random& random, Noise noise, int samples)
{
    double sum = 0;
    for (int i = 0; i < samples; ++i) sum += noise(random);
    return sum / samples;
}

using Light = std::function<double(int, int)>;

/// A lit floor with a dark ball and a background without noise, for pictures of 64 x 64.
inline double floor_and_ball(int x, int y)
{
    if (y < 12) return 0;
    return std::hypot(x - 30, y - 40) < 14 ? 0.02 : 0.05 + 0.004 * x;
}

/// A picture of linear light in floats; every pixel and channel the mean of `samples` estimates.
inline Tensor noisy(Random& random, int width, int height, int channels, int samples, const Light& light,
                    Noise noise = exponential)
{
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                   static_cast<std::size_t>(channels));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                values.push_back(static_cast<float>(light(x, y) * mean_of(random, noise, samples)));
    Tensor tensor = floats(values, static_cast<std::uint32_t>(channels));
    tensor.rows = static_cast<std::uint32_t>(height);
    tensor.columns = static_cast<std::uint32_t>(width);
    return tensor;
}

/// The same picture as sRGB in bytes; clipped at 255 as pictures are.
inline Tensor as_bytes(const Tensor& light)
{
    Tensor tensor{Element::uint8, light.rows, light.columns, light.components, {}, {}};
    tensor.bytes.reserve(light.count());
    for (std::size_t i = 0; i < light.count(); ++i) {
        float value = 0;
        std::memcpy(&value, light.bytes.data() + i * sizeof value, sizeof value);
        const double code = value <= 0.0031308F ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
        tensor.bytes.push_back(std::byte{byte(255 * code)});
    }
    return tensor;
}

}
