#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <umbral/record/literal.hpp>
#include <vector>

namespace umbral::sample {

struct Drop {
    glm::vec3 centre;
    float radius;
};
enum class Layer { bottom, top };

}

namespace umbral {
namespace {

using namespace sample;

TEST(Literal, gives_back_exactly_the_value)
{
    EXPECT_EQ(literal::of(16777217.0), "16777217");
    EXPECT_EQ(literal::of(0.1), "0.1");
    EXPECT_EQ(literal::of(-0.0), "-0.0");
    EXPECT_EQ(literal::of(1e10F), "1e+10F");
    EXPECT_EQ(literal::of(std::nextafter(1.0F, 2.0F)), "1.0000001F");
    EXPECT_EQ(literal::of(-INFINITY), "-INFINITY");
    EXPECT_EQ(literal::of(NAN), "NAN");
    EXPECT_EQ(literal::of_integer(std::uint64_t{4294967295}), "4294967295U");
    EXPECT_EQ(literal::of_text("a\"\\\n\x01"
                               "7",
                               literal::in_full),
              R"("a\"\\\n\0017")");
    EXPECT_EQ(literal::of_text("1 0\t\r", literal::in_full), R"("1 0\t\r")");
}

TEST(Literal, leaves_the_lines_of_a_text_as_they_are)
{
    const std::string shader = "void main()\n{\n    discard;\n}\n";
    EXPECT_EQ(literal::of_text(shader, {}), "R\"(" + shader + ")\"");
    EXPECT_EQ(literal::of_text(shader, {.most_lines = 2}), "R\"(void main()\n{\n)\" … 2 more lines");
    EXPECT_EQ(literal::of_text("one\n", {}), "\"one\\n\"") << "a single line";
    EXPECT_EQ(literal::of_text("a)\"\nb", {}), "\"a)\\\"\\nb\"") << "what would end it";
    EXPECT_EQ(literal::of_text("a\x01\nb", {}), "\"a\\001\\nb\"") << "what nobody could read";
}

/// What the code gives is the matrix, bit by bit: -0 is another number.
TEST(Literal, writes_simple_matrices_as_calls)
{
    const auto code = [](const auto& value) { return literal::of_value(value, true, {}); };
    const auto is = [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    EXPECT_EQ(code(glm::mat4(1)), "glm::mat4(1)");
    EXPECT_EQ(code(glm::mat3(-0.5F)), "glm::mat3(-0.5F)");
    EXPECT_EQ(code(glm::dmat4(0)), "glm::dmat4(0)");
    EXPECT_EQ(code(std::vector<glm::mat2>{glm::mat2(1), {1, 2, 3, 4}}),
              "std::vector<glm::mat2>{glm::mat2(1), {{1, 2}, {3, 4}}}");
    const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3{1, -2.5F, 0});
    EXPECT_EQ(code(moved), "glm::translate(glm::mat4(1), glm::vec3{1, -2.5F, 0})");
    const glm::dmat4 scaled = glm::scale(glm::dmat4(1), glm::dvec3{1, 0.1, 3});
    EXPECT_EQ(code(scaled), "glm::scale(glm::dmat4(1), glm::dvec3{1, 0.1, 3})");
    glm::mat4 other = moved;
    other[3][2] = -0.0F;
    ASSERT_FALSE(is(other, moved));
    EXPECT_TRUE(code(other).starts_with("glm::mat4{{1, 0,")) << code(other);
    const glm::mat4 mirrored = glm::scale(glm::mat4(1), glm::vec3{-1, 1, 1});
    EXPECT_TRUE(code(mirrored).starts_with("glm::mat4{{-1, -0.0F")) << code(mirrored);
    EXPECT_TRUE(code(moved * glm::mat4(scaled)).starts_with("glm::mat4{{1, 0")) << "both at once";
    glm::mat4 projective(1);
    projective[2][3] = 1;
    EXPECT_TRUE(code(projective).starts_with("glm::mat4{{1, 0")) << code(projective);
}

TEST(Literal, writes_types_as_people_do)
{
    const auto code = [](const auto& value) { return literal::of_value(value, true, literal::in_full); };
    EXPECT_EQ(code(glm::mat2(1, 2, 3, 4)), "glm::mat2{{1, 2}, {3, 4}}");
    EXPECT_EQ(code(std::vector<glm::uvec3>{{1, 2, 3}}), "std::vector<glm::uvec3>{{1, 2, 3}}");
    EXPECT_EQ(code(std::vector<std::vector<std::uint32_t>>{{1}, {}}),
              "std::vector<std::vector<std::uint32_t>>{{1}, {}}");
    EXPECT_EQ(code(std::vector<std::uint64_t>{1}), "std::vector<std::uint64_t>{1}");
    EXPECT_EQ(code(std::vector<Drop>{{{1, 2, 3}, 4}}), "std::vector<Drop>{{{1, 2, 3}, 4}}");
    EXPECT_EQ(code(std::array{1.0F, 2.0F}), "std::array<float, 2>{1, 2}");
    EXPECT_EQ(code(std::array{glm::vec2(1, 2), glm::vec2(3, 4)}), "std::array<glm::vec2, 2>{{{1, 2}, {3, 4}}}");
    EXPECT_EQ(code(static_cast<Layer>(7)), "Layer{7}");
    EXPECT_EQ(code(std::string("x")), "\"x\"");
    EXPECT_EQ(code(true), "true");
}

}
}
