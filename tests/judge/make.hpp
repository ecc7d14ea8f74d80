#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <umbral/core/random.hpp>
#include <vector>

#include "judge/judge.hpp"

namespace umbral::grader::test {

template <class Value>
Tensor table(Element element, std::uint32_t components, const std::vector<Value>& values)
{
    Tensor tensor{element, static_cast<std::uint32_t>(values.size() / components), 1, components, {}, {}};
    tensor.bytes.resize(values.size() * sizeof(Value));
    if (!values.empty()) std::memcpy(tensor.bytes.data(), values.data(), tensor.bytes.size());
    return tensor;
}

inline Tensor floats(const std::vector<float>& values, std::uint32_t components = 1)
{
    return table(Element::float32, components, values);
}
inline Tensor doubles(const std::vector<double>& values, std::uint32_t components = 1)
{
    return table(Element::float64, components, values);
}

/// What Recorder::text records.
inline Tensor text(const std::string& value)
{
    return table(Element::uint8, 1, std::vector<char>(value.begin(), value.end()));
}

inline Tensor optional_floats(const std::vector<float>& values, const std::vector<std::uint8_t>& present)
{
    Tensor tensor = floats(values);
    tensor.present = present;
    return tensor;
}

inline Tensor grid(std::uint32_t width, std::uint32_t height, const std::vector<std::uint32_t>& ids)
{
    Tensor tensor = table(Element::uint32, 1, ids);
    tensor.rows = height;
    tensor.columns = width;
    return tensor;
}

inline Tensor depth(std::uint32_t width, std::uint32_t height, const std::vector<float>& values)
{
    Tensor tensor = floats(values);
    tensor.rows = height;
    tensor.columns = width;
    return tensor;
}

using Colour = glm::u8vec4;

/// A picture of bytes from a function of the pixel.
inline Tensor picture(int width, int height, const std::function<Colour(int, int)>& paint)
{
    Tensor tensor{Element::uint8, static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(width), 4, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Colour colour = paint(x, y);
            for (glm::length_t c = 0; c < 4; ++c) tensor.bytes.push_back(std::byte{colour[c]});
        }
    return tensor;
}

inline Colour pixel(const Tensor& tensor, int x, int y)
{
    const std::size_t at = (static_cast<std::size_t>(y) * tensor.columns + static_cast<std::size_t>(x)) * 4;
    const auto value = [&](std::size_t c) { return std::to_integer<std::uint8_t>(tensor.bytes[at + c]); };
    return {value(0), value(1), value(2), value(3)};
}

/// Another picture of the same size, painted from this one.
inline Tensor repaint(const Tensor& tensor, const std::function<Colour(int, int)>& paint)
{
    return picture(static_cast<int>(tensor.columns), static_cast<int>(tensor.rows), paint);
}

inline std::uint8_t byte(double value)
{
    return static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value, 0.0), 255.0)));
}

/// Two shaded balls of different colours on dark blue, nothing symmetric about them: what a course's picture looks
/// like.
inline Tensor balls(int size = 128)
{
    return picture(size, size, [size](int px, int py) {
        const double x = (px + 0.5) / size;
        const double y = (py + 0.5) / size;
        const auto shade = [&](double cx, double cy, double radius) {
            const double dx = (x - cx) / radius;
            const double dy = (y - cy) / radius;
            const double inside = 1 - dx * dx - dy * dy;
            return inside <= 0 ? -1.0 : std::fmax(0.0, (0.6 * -dx + 0.4 * -dy + 0.7 * std::sqrt(inside)));
        };
        const double red = shade(0.35, 0.4, 0.25);
        const double green = shade(0.7, 0.62, 0.15);
        if (red >= 0) return Colour{byte(30 + 170 * red), byte(20 + 60 * red), byte(25 + 30 * red), 255};
        if (green >= 0) return Colour{byte(20 + 40 * green), byte(35 + 150 * green), byte(30 + 80 * green), 255};
        return Colour{8, 10, 40, 255};
    });
}

/// balls(), painted once: for pictures that are painted from it.
inline const Tensor& scene()
{
    static const Tensor once = balls();
    return once;
}

inline Check check_of(JudgeKind kind, Tolerance tolerance = {})
{
    Check check;
    check.name = "case/value";
    check.judge = kind;
    check.points = 2000;
    check.tolerance = tolerance;
    return check;
}

inline Tolerance absolute(double bound) { return {bound, {}, {}, {}}; }
inline Tolerance relative(double bound) { return {{}, bound, {}, {}}; }
inline Tolerance ulps(double bound) { return {{}, {}, bound, {}}; }

}
