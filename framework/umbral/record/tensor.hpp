#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace umbral {

/// What one element of a tensor is. The numbers stand in the recording's file format: never change them.
enum class Element : std::uint32_t { float32 = 1, float64 = 2, int32 = 3, uint32 = 4, uint8 = 5 };

/// Bytes of one element; 0 for a value that is not an Element.
[[nodiscard]] constexpr std::size_t size_of(Element element) noexcept
{
    switch (element) {
        case Element::float32:
        case Element::int32:
        case Element::uint32: return 4;
        case Element::float64: return 8;
        case Element::uint8: return 1;
    }
    return 0;
}

/// One observation under one name: a table of values, or a picture.
///
/// Shape: `rows` x `columns` x `components`, stored row by row, the components of a cell together. A list of n vectors
/// is n x 1 x 3, a list of n matrices n x 1 x 16 (column-major, as GLM), a picture height x width x channels (top row
/// first). `present` is empty where every cell has a value; otherwise it holds one byte a cell, 0 where there is none
/// (std::nullopt), and the bytes of an absent cell are 0.
struct Tensor {
    Element element = Element::float32;
    std::uint32_t rows = 0;
    std::uint32_t columns = 0;
    std::uint32_t components = 1;
    std::vector<std::byte> bytes;
    std::vector<std::uint8_t> present;

    [[nodiscard]] std::size_t cells() const noexcept { return std::size_t{rows} * columns; }
    [[nodiscard]] std::size_t count() const noexcept { return cells() * components; }
    friend bool operator==(const Tensor&, const Tensor&) = default;
};

}
