#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "unit/own_file.hpp"

// What two recordings of one file have in common. The student's may hold anything that parse_recording lets through.
namespace umbral::grader::test {
namespace {

template <class Number>
Tensor table(Element element, std::uint32_t components, const std::vector<Number>& numbers)
{
    Tensor tensor{.element = element,
                  .rows = static_cast<std::uint32_t>(numbers.size()) / components,
                  .columns = 1,
                  .components = components,
                  .bytes = std::vector<std::byte>(numbers.size() * sizeof(Number)),
                  .present = {}};
    std::memcpy(tensor.bytes.data(), numbers.data(), tensor.bytes.size());
    return tensor;
}

Tensor floats(std::uint32_t components, const std::vector<float>& numbers)
{
    return table(Element::float32, components, numbers);
}

Tensor text(const std::string& letters)
{
    return table(Element::uint8, 1, std::vector<std::uint8_t>(letters.begin(), letters.end()));
}

FileValue compared(const Tensor& yours, const Tensor& expected)
{
    Recording student;
    Recording reference;
    student.tensors.emplace("value", yours);
    reference.tensors.emplace("value", expected);
    return compare_readings(student, reference).at(0);
}

TEST(OwnFile, rows_are_compared_up_to_the_first_that_differs)
{
    const FileValue value = compared(floats(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}), floats(3, {1, 2, 3, 4, 5, 7, 0, 0, 0}));
    EXPECT_FALSE(value.same);
    EXPECT_EQ(value.first, "row 1: yours (4, 5, 6), expected (4, 5, 7)");
    EXPECT_EQ(value.yours, "3 rows");
}

TEST(OwnFile, values_that_differ_never_look_alike)
{
    const FileValue value = compared(floats(1, {1, 0.1F}), floats(1, {1, std::nextafter(0.1F, 1.0F)}));
    EXPECT_FALSE(value.same);
    EXPECT_EQ(value.first, "row 1: yours 0.1, expected 0.10000001");
}

TEST(OwnFile, a_nan_equals_a_nan_and_zeros_are_equal)
{
    EXPECT_TRUE(compared(floats(1, {NAN, -0.0F}), floats(1, {-NAN, 0.0F})).same);
    EXPECT_FALSE(compared(floats(1, {NAN, 1}), floats(1, {1, NAN})).same);
}

TEST(OwnFile, tables_that_end_early_or_go_on)
{
    EXPECT_EQ(compared(floats(1, {1, 2}), floats(1, {1, 2, 3})).first, "row 2: yours end here");
    EXPECT_EQ(compared(floats(1, {1, 2, 3}), floats(1, {1, 2})).first, "row 2: yours go on");
}

TEST(OwnFile, what_is_missing_or_of_another_shape_differs)
{
    Recording reference;
    reference.tensors.emplace("positions", floats(3, {1, 2, 3, 4, 5, 6}));
    reference.tensors.emplace("count", floats(1, {2}));
    reference.tensors.emplace("outcome", text("read"));
    const std::vector<FileValue> values = compare_readings({}, reference);
    ASSERT_EQ(values.size(), 3U);
    EXPECT_EQ(values[0].name, "outcome") << "texts come first, tables last";
    EXPECT_EQ(values[1].name, "count");
    for (const FileValue& value : values) EXPECT_FALSE(value.same) << value.name;
    EXPECT_FALSE(compared(floats(1, {1, 2}), floats(2, {1, 2, 3, 4})).same);
    EXPECT_FALSE(compared(text("read"), floats(1, {1})).same);
}

TEST(OwnFile, messages_are_shown_and_not_compared)
{
    Recording student;
    Recording reference;
    student.tensors.emplace("message", text("line 3"));
    reference.tensors.emplace("message", text("in line 3"));
    EXPECT_TRUE(compare_readings(student, reference).empty());
    EXPECT_EQ(message_of(student), "line 3");
    EXPECT_EQ(message_of({}), "");
}

}
}
