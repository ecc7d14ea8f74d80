#include "explain/same_values.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace umbral::grader {
namespace {

template <class Number>
Tensor column(Element element, const std::vector<Number>& numbers)
{
    Tensor tensor{element, static_cast<std::uint32_t>(numbers.size()), 1, 1, {}, {}};
    tensor.bytes.resize(numbers.size() * sizeof(Number));
    std::memcpy(tensor.bytes.data(), numbers.data(), tensor.bytes.size());
    return tensor;
}

constexpr float nan_of_floats = std::numeric_limits<float>::quiet_NaN();
constexpr double nan_of_doubles = std::numeric_limits<double>::quiet_NaN();

// 0 * infinity is a NaN with a sign on this machine, and std::nan one without: the same answer to a student.
TEST(SameValues, are_nans_whatever_their_bits)
{
    EXPECT_TRUE(are_same_values(column<float>(Element::float32, {1, nan_of_floats}),
                                column<float>(Element::float32, {1, -nan_of_floats})));
    EXPECT_TRUE(are_same_values(column<double>(Element::float64, {nan_of_doubles, 2}),
                                column<double>(Element::float64, {-nan_of_doubles, 2})));
}

TEST(SameValues, are_no_others)
{
    const Tensor floats = column<float>(Element::float32, {1, nan_of_floats});
    EXPECT_TRUE(are_same_values(floats, floats));
    EXPECT_FALSE(are_same_values(floats, column<float>(Element::float32, {1, 2})));
    EXPECT_FALSE(are_same_values(floats, column<float>(Element::float32, {2, nan_of_floats})));
    EXPECT_FALSE(are_same_values(floats, column<float>(Element::float32, {1, nan_of_floats, 1})));
    EXPECT_FALSE(are_same_values(column<float>(Element::float32, {0}), column<float>(Element::float32, {-0.0F})));
    EXPECT_FALSE(are_same_values(column<std::int32_t>(Element::int32, {1}), column<std::int32_t>(Element::int32, {2})));
    // Bits of NaNs in whole numbers are numbers.
    EXPECT_FALSE(are_same_values(column<std::uint32_t>(Element::uint32, {0x7FC00000U}),
                                 column<std::uint32_t>(Element::uint32, {0xFFC00000U})));
}

}
}
