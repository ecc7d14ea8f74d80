#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "judge/judges.hpp"
#include "judge/picture/srgb.hpp"
#include "judge/picture/to_image.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

constexpr glm::u8vec4 not_a_number(255, 0, 255, 255);

[[noreturn]] void refuse(const Check& check, const std::string& what)
{
    throw std::invalid_argument("check '" + check.name + "': cannot be drawn: " + what);
}

template <class Value>
Value element(const Tensor& tensor, std::size_t index)
{
    Value value;
    std::memcpy(&value, tensor.bytes.data() + index * sizeof value, sizeof value);
    return value;
}

/// Turns of the colour circle by the golden section put neighbouring ids far apart; three shades tell later rounds from
/// earlier ones.
glm::u8vec4 colour_of_id(std::uint32_t id)
{
    if (id == 0) return {0, 0, 0, 255};
    const double hue = 6 * std::fmod(id * 0.6180339887498949, 1.0);
    const double saturation = 0.45 + 0.2 * (id % 3);
    const double value = 1.0 - 0.18 * (id / 3 % 3);
    const auto channel = [&](double offset) {
        const double place = std::fmod(offset + hue, 6.0);
        const double amount = std::clamp(std::min(place, 4 - place), 0.0, 1.0);
        return static_cast<glm::u8>(std::lround(255 * value * (1 - saturation * amount)));
    };
    return {channel(5), channel(3), channel(1), 255};
}

template <class Value>
glm::u8vec4 measured(const Tensor& tensor, const Check& check, std::size_t cell)
{
    glm::u8vec4 colour(0, 0, 0, 255);
    for (std::uint32_t c = 0; c < tensor.components; ++c) {
        const double value = static_cast<double>(element<Value>(tensor, cell * tensor.components + c));
        if (std::isnan(value)) return not_a_number;
        const double share = std::clamp((value - check.range_low) / (check.range_high - check.range_low), 0.0, 1.0);
        colour[static_cast<int>(c)] = static_cast<glm::u8>(
            std::lround(255 * (judge_of(check).look == Look::light ? srgb_encoded(share) : share)));
    }
    if (tensor.components == 1) colour.g = colour.b = colour.r;
    return colour;
}

glm::u8vec4 bytes(const Tensor& tensor, std::size_t cell)
{
    glm::u8vec4 colour(0, 0, 0, 255);
    for (std::uint32_t c = 0; c < tensor.components; ++c)
        colour[static_cast<int>(c)] = element<glm::u8>(tensor, cell * tensor.components + c);
    if (tensor.components == 1) colour.g = colour.b = colour.r;
    return colour;
}

glm::u8vec4 colour_of(const Tensor& tensor, const Check& check, std::size_t cell)
{
    if (!tensor.present.empty() && tensor.present[cell] == 0) return {0, 0, 0, 0};
    switch (tensor.element) {
        case Element::uint8: return bytes(tensor, cell);
        case Element::float32: return measured<float>(tensor, check, cell);
        case Element::float64: return measured<double>(tensor, check, cell);
        case Element::int32:
        case Element::uint32: return colour_of_id(element<std::uint32_t>(tensor, cell));
    }
    refuse(check, "unknown type of element " + std::to_string(static_cast<unsigned>(tensor.element)));
}

}

Image to_image(const Tensor& tensor, const Check& check)
{
    const bool ids = tensor.element == Element::int32 || tensor.element == Element::uint32;
    const bool floats = is_real(tensor.element);
    if (ids ? tensor.components != 1 : tensor.components != 1 && tensor.components != 3 && tensor.components != 4)
        refuse(check, std::string("expected ") + (ids ? "1 channel" : "1, 3 or 4 channels") + ", got " +
                          std::to_string(tensor.components));
    if (floats && !(check.range_high > check.range_low)) refuse(check, "its range is empty");
    if (tensor.bytes.size() != tensor.count() * size_of(tensor.element))
        refuse(check, "its bytes do not fit its shape");
    if (!tensor.present.empty() && tensor.present.size() != tensor.cells())
        refuse(check, "its presence flags do not fit its shape");

    Image image(static_cast<int>(tensor.columns), static_cast<int>(tensor.rows));
    for (std::size_t cell = 0; cell < image.cells.size(); ++cell) image.cells[cell] = colour_of(tensor, check, cell);
    return image;
}

}
