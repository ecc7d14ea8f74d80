#pragma once

#include <concepts>
#include <cstring>
#include <span>
#include <umbral/record/tensor.hpp>

namespace umbral {

/// The Element that holds a number as it is.
template <class Number>
inline constexpr Element element_of = [] {
    if constexpr (std::same_as<Number, double>) return Element::float64;
    if constexpr (std::same_as<Number, std::uint32_t>) return Element::uint32;
    if constexpr (std::same_as<Number, char>) return Element::uint8;
}();

/// A list of rows, of so many numbers each, one after the other. Numbers behind the last whole row are no part of it.
template <class Number>
[[nodiscard]] Tensor tensor_of(std::span<const Number> numbers, std::size_t components = 1)
{
    const std::size_t rows = numbers.size() / components;
    Tensor tensor{
        element_of<Number>, static_cast<std::uint32_t>(rows), 1, static_cast<std::uint32_t>(components), {}, {}};
    tensor.bytes.resize(rows * components * sizeof(Number));
    if (rows > 0) std::memcpy(tensor.bytes.data(), numbers.data(), tensor.bytes.size());
    return tensor;
}

}
