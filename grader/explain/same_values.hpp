#pragma once

#include <cmath>
#include <cstring>
#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// Do two recordings of a value hold the same? No number is the same as no number: which bits a NaN has, its sign among
/// them, follows from the instructions that a compiler chose, and not from what the program computes.
[[nodiscard]] inline bool are_same_values(const Tensor& a, const Tensor& b)
{
    if (a == b) return true;
    if (a.element != b.element || a.rows != b.rows || a.columns != b.columns || a.components != b.components ||
        a.present != b.present || a.bytes.size() != b.bytes.size())
        return false;
    const auto agree = [&]<class Number>(Number) {
        for (std::size_t at = 0; at + sizeof(Number) <= a.bytes.size(); at += sizeof(Number)) {
            Number in_a = 0;
            Number in_b = 0;
            std::memcpy(&in_a, a.bytes.data() + at, sizeof in_a);
            std::memcpy(&in_b, b.bytes.data() + at, sizeof in_b);
            if (std::memcmp(&in_a, &in_b, sizeof in_a) != 0 && !(std::isnan(in_a) && std::isnan(in_b))) return false;
        }
        return true;
    };
    switch (a.element) {
        case Element::float32: return agree(float{});
        case Element::float64: return agree(double{});
        default: return false;
    }
}

}
