#include "bench/explanations/disturb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <string>

namespace umbral::grader {
namespace {

Tensor floats(std::uint32_t rows, std::uint32_t columns, std::uint64_t seed)
{
    Random random(seed);
    Tensor tensor{Element::float32,
                  rows,
                  columns,
                  3,
                  std::vector<std::byte>(std::size_t{rows} * columns * 3 * sizeof(float)),
                  {}};
    for (std::size_t i = 0; i < tensor.count(); ++i) {
        const float value = random.uniform(-2, 5);
        std::memcpy(tensor.bytes.data() + i * sizeof value, &value, sizeof value);
    }
    return tensor;
}

float value_at(const Tensor& tensor, std::size_t index)
{
    float value = 0;
    std::memcpy(&value, tensor.bytes.data() + index * sizeof value, sizeof value);
    return value;
}

TEST(Disturb, each_changes_a_picture_keeps_its_shape_and_repeats_itself)
{
    Tensor right = floats(24, 32, 5);
    right.present.assign(right.cells(), 1);
    std::set<std::string> names;
    for (const Disturbance& one : disturbances()) {
        names.insert(one.name);
        Random a(7);
        Random b(7);
        const Tensor wrong = one.apply(right, a);
        EXPECT_FALSE(wrong == right) << one.name;
        EXPECT_TRUE(wrong == one.apply(right, b)) << one.name;
        EXPECT_EQ(wrong.bytes.size(), right.bytes.size()) << one.name;
        EXPECT_EQ(wrong.present.size(), right.present.size()) << one.name;
        EXPECT_EQ(wrong.rows, right.rows);
        EXPECT_EQ(wrong.components, right.components);
    }
    EXPECT_EQ(names.size(), disturbances().size());
}

TEST(Disturb, tables_and_empty_ones_are_taken_too)
{
    for (const std::uint32_t rows : {0U, 1U, 2U, 50U})
        for (const Disturbance& one : disturbances()) {
            Random random(rows);
            const Tensor right = floats(rows, 1, rows);
            EXPECT_EQ(one.apply(right, random).bytes.size(), right.bytes.size()) << one.name;
        }
}

TEST(Disturb, rounding_moves_floats_by_one_ulp_and_bytes_by_one_level)
{
    const Tensor right = floats(40, 1, 11);
    Random random(3);
    const Tensor rounded = rounded_otherwise(right, random);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < right.count(); ++i) {
        const float before = value_at(right, i);
        const float after = value_at(rounded, i);
        EXPECT_TRUE(after == before || after == std::nextafter(before, -INFINITY) ||
                    after == std::nextafter(before, INFINITY))
            << before << ' ' << after;
        moved += after == before ? 0 : 1;
    }
    EXPECT_GT(moved, right.count() / 2);

    Tensor bytes{Element::uint8, 30, 30, 1, std::vector<std::byte>(900, std::byte{255}), {}};
    bytes.bytes[0] = std::byte{0};
    const Tensor levels = rounded_otherwise(bytes, random);
    EXPECT_FALSE(levels == bytes);
    for (std::size_t i = 0; i < bytes.bytes.size(); ++i)
        EXPECT_LE(std::abs(std::to_integer<int>(levels.bytes[i]) - std::to_integer<int>(bytes.bytes[i])), 1) << i;

    const Tensor text{Element::uint8, 5, 1, 1, std::vector<std::byte>(5, std::byte{65}), {}};
    EXPECT_TRUE(rounded_otherwise(text, random) == text);
}

}
}
