#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
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
