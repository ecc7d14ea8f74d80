#pragma once

#include <cstdint>
#include <umbral/core/grid.hpp>
#include <vector>

#include "model/exercise.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// A picture as planes of bytes, one per channel, with a border of one repeated pixel: what neighbourhoods can be read
/// from without asking where the edge is, and compilers turn into vector code.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<std::uint8_t> planes;

    [[nodiscard]] std::size_t stride() const noexcept { return static_cast<std::size_t>(width) + 2; }
    /// Row y of a channel, y in -1 .. height; element 0 is the pixel in column 0, element -1 the border.
    [[nodiscard]] const std::uint8_t* row(int channel, int y) const noexcept
    {
        return planes.data() + offset(channel, y);
    }
    [[nodiscard]] std::uint8_t* row(int channel, int y) noexcept { return planes.data() + offset(channel, y); }
    /// Channels that carry light; the fourth is alpha.
    [[nodiscard]] int colours() const noexcept { return channels < 3 ? 1 : 3; }

private:
    [[nodiscard]] std::size_t offset(int channel, int y) const noexcept
    {
        const std::size_t line = static_cast<std::size_t>(channel) * (static_cast<std::size_t>(height) + 2) +
                                 static_cast<std::size_t>(y + 1);
        return line * stride() + 1;
    }
};

/// The picture in a tensor of 1, 3 or 4 channels of bytes or floats. Floats are mapped so that check.range_low is 0 and
/// range_high 255, rounded, and clamped: beyond the range the check does not look. Throws std::invalid_argument for any
/// other tensor or an empty range.
[[nodiscard]] Picture to_picture(const Check& check, const Tensor& tensor);

/// An image as a tensor: bytes, the first `channels` (1..4) of each pixel.
[[nodiscard]] Tensor as_tensor(const Image& image, std::uint32_t channels = 4);

/// Throws what to_picture would throw for this tensor, at no cost.
void check_picture(const Check& check, const Tensor& tensor);

/// Do all values exist and are they finite? (Bytes always are.)
[[nodiscard]] bool complete(const Tensor& tensor);

}
