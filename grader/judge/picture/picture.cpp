#include "judge/picture/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

// The number of channels is a constant, so that reading every fourth byte becomes vector code.
template <std::size_t channels, class Value, class Convert>
void split_channels(const Tensor& tensor, Picture& picture, Convert convert)
{
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t c = 0; c < channels; ++c)
        for (int y = 0; y < picture.height; ++y) {
            const std::byte* __restrict source =
                tensor.bytes.data() + (static_cast<std::size_t>(y) * width * channels + c) * sizeof(Value);
            std::uint8_t* __restrict target = picture.row(static_cast<int>(c), y);
            for (std::size_t x = 0; x < width; ++x) {
                Value value;
                std::memcpy(&value, source + x * channels * sizeof(Value), sizeof(Value));
                target[x] = convert(value);
            }
        }
}

template <class Value, class Convert>
void split(const Tensor& tensor, Picture& picture, Convert convert)
{
    switch (picture.channels) {
        case 1: return split_channels<1, Value>(tensor, picture, convert);
        case 3: return split_channels<3, Value>(tensor, picture, convert);
        default: return split_channels<4, Value>(tensor, picture, convert);
    }
}

void repeat_border(Picture& picture)
{
    for (int c = 0; c < picture.channels; ++c) {
        for (int y = 0; y < picture.height; ++y) {
            std::uint8_t* row = picture.row(c, y);
            row[-1] = row[0];
            row[picture.width] = row[picture.width - 1];
        }
        std::memcpy(picture.row(c, -1) - 1, picture.row(c, 0) - 1, picture.stride());
        std::memcpy(picture.row(c, picture.height) - 1, picture.row(c, picture.height - 1) - 1, picture.stride());
    }
}

}

void check_picture(const Check& check, const Tensor& tensor)
{
    const bool floats = is_real(tensor.element);
    const std::uint32_t channels = tensor.components;
    if ((!floats && tensor.element != Element::uint8) || (channels != 1 && channels != 3 && channels != 4) ||
        tensor.cells() == 0)
        throw std::invalid_argument("check '" + check.name +
                                    "': expected a picture of 1, 3 or 4 channels of bytes or floats");
    if (floats && !(check.range_high > check.range_low))
        throw std::invalid_argument("check '" + check.name +
                                    "': the range of a picture must be two different numbers, the lower one first");
}

Picture to_picture(const Check& check, const Tensor& tensor)
{
    check_picture(check, tensor);
    Picture picture{
        static_cast<int>(tensor.columns), static_cast<int>(tensor.rows), static_cast<int>(tensor.components), {}};
    picture.planes.resize(tensor.components * (std::size_t{tensor.rows} + 2) * picture.stride());
    const double low = check.range_low;
    const double scale = 255.0 / (check.range_high - check.range_low);
    const auto level = [low, scale](auto value) {
        const double mapped = (static_cast<double>(value) - low) * scale;
        return static_cast<std::uint8_t>(mapped > 0 ? std::min(mapped, 255.0) + 0.5 : 0.5);
    };
    if (tensor.element == Element::uint8)
        split<std::uint8_t>(tensor, picture, [](std::uint8_t value) { return value; });
    else if (tensor.element == Element::float32)
        split<float>(tensor, picture, level);
    else
        split<double>(tensor, picture, level);
    repeat_border(picture);
    return picture;
}

Tensor as_tensor(const Image& image, std::uint32_t channels)
{
    Tensor tensor{Element::uint8,
                  static_cast<std::uint32_t>(image.height),
                  static_cast<std::uint32_t>(image.width),
                  channels,
                  {},
                  {}};
    tensor.bytes.resize(tensor.count());
    for (std::size_t i = 0; i < image.cells.size(); ++i)
        std::memcpy(tensor.bytes.data() + i * channels, &image.cells[i], channels);
    return tensor;
}

bool complete(const Tensor& tensor)
{
    if (std::any_of(tensor.present.begin(), tensor.present.end(), [](std::uint8_t present) { return present == 0; }))
        return false;
    return !is_real(tensor.element) || all_finite(to_doubles(tensor));
}

}
