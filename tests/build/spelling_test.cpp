#include "build/spelling.hpp"

#include <gtest/gtest.h>

#include "build/check_names.hpp"
#include "build/forbidden.hpp"

namespace umbral::grader::test {
namespace {

TEST(AsWritten, names_types_as_students_do)
{
    EXPECT_EQ(as_written("f(glm::vec<3, float, (glm::qualifier)0>)"), "f(glm::vec3)");
    EXPECT_EQ(
        as_written("f(glm::vec<2, unsigned int, (glm::qualifier)0> const&, glm::mat<4, 4, double, (glm::qualifier)0>)"),
        "f(glm::uvec2 const&, glm::dmat4)");
    EXPECT_EQ(as_written("f(std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> >)"),
              "f(std::string)");
    EXPECT_EQ(as_written("f(glm::mat<4, 3, float, (glm::qualifier)0>)"), "f(glm::mat<4, 3, float, (glm::qualifier)0>)");
}

TEST(WithoutComments, leaves_the_rest)
{
    EXPECT_EQ(without_comments("a // b\nc /* d\n e */ f"), "a  \nc   f");
    EXPECT_EQ(without_comments("a /* open"), "a  ");
    EXPECT_EQ(without_comments("a // b \\\nstill comment\nc"), "a  \nc");
    // As OpenGL's compilers end lines.
    EXPECT_EQ(without_comments("a // b\rc"), "a  \rc");
    EXPECT_EQ(without_comments("re\\\rflect re\\\n\rflect re\\\r\nflect"), "reflect reflect reflect");
    EXPECT_EQ(without_comments("a // b \\\r\r\nc"), "a  \r\nc");
    EXPECT_EQ(without_comments("loo\\\nkAt loo\\\r\nkAt"), "lookAt lookAt");
    EXPECT_EQ(without_comments("/**//***/x/*/*/y"), "  x y");
}

// The comment of 26 KB that once ended the grading of a class, and one of 64 MB.
TEST(WithoutComments, is_linear_in_any_text)
{
    for (const std::size_t size : {std::size_t{26} << 10U, std::size_t{64} << 20U}) {
        EXPECT_EQ(without_comments("/*" + std::string(size, '*') + "/x"), " x");
        EXPECT_EQ(without_comments(std::string(size, '/')), " ");
    }
}

TEST(HoldsWord, is_about_whole_words)
{
    EXPECT_TRUE(holds_word("x = lookAt(a)", "lookAt"));
    EXPECT_TRUE(holds_word("lookAt", "lookAt"));
    EXPECT_FALSE(holds_word("my_lookAt lookAt2 xlookAt", "lookAt"));
    EXPECT_TRUE(holds_word("lookAt2 lookAt", "lookAt"));
}

// The compilers of shaders know ##, as that of C++ does.
TEST(CheckWords, finds_no_name_that_is_put_together_unseen)
{
    Exercise exercise;
    exercise.forbid = {"reflect"};
    EXPECT_TRUE(check_words({{"a.frag", "vec3 r = reflect(v, n);"}}, exercise));
    EXPECT_TRUE(check_words({{"a.frag", "#define GLUE(a, b) a##b\nvec3 r = GLUE(refl, ect)(v, n);"}}, exercise));
    EXPECT_TRUE(check_words({{"a.frag", "#define GLUE(a, b) a #\\\n# b\nvec3 r = GLUE(refl, ect)(v, n);"}}, exercise));
    EXPECT_FALSE(check_words({{"a.frag", "// ## reflect\nvec3 r = mirrored(v, n);"}}, exercise));
    exercise.forbid.clear();
    EXPECT_FALSE(check_words({{"a.frag", "#define GLUE(a, b) a##b"}}, exercise));
}

TEST(MatchesPattern, star_stands_for_anything)
{
    EXPECT_TRUE(matches_pattern("glm::rotate_slow", "glm::rotate*"));
    EXPECT_TRUE(matches_pattern("glm::rotate", "glm::rotate*"));
    EXPECT_TRUE(matches_pattern("glm::quatLookAtRH", "glm::*LookAt*"));
    EXPECT_FALSE(matches_pattern("glm::rotate", "glm::rot"));
    EXPECT_FALSE(matches_pattern("my::glm::rotate", "glm::rotate"));
    EXPECT_TRUE(matches_pattern("", "*"));
    EXPECT_TRUE(matches_pattern("", ""));
    EXPECT_FALSE(matches_pattern("a", ""));
    EXPECT_TRUE(matches_pattern("aXbXc", "a*b*c"));
    EXPECT_FALSE(matches_pattern("aXbX", "a*b*c"));
    EXPECT_FALSE(matches_pattern(std::string(20000, 'a'), "*a*a*a*a*b"));
}

TEST(QualifiedName, drops_what_is_returned_taken_and_instantiated)
{
    EXPECT_EQ(qualified_name("glm::mat<4, 4, float, (glm::qualifier)0> glm::lookAt<float, "
                             "(glm::qualifier)0>(glm::vec<3, float> const&)"),
              "glm::lookAt");
    EXPECT_EQ(qualified_name("glm::qua<float, (glm::qualifier)0>::operator float() const"), "glm::qua::operator float");
    EXPECT_EQ(qualified_name("main"), "main");
    EXPECT_EQ(qualified_name("(anonymous namespace)::f(int)"), "(anonymous namespace)::f");
    EXPECT_EQ(qualified_name("bool std::operator< <int>(std::vector<int> const&)"), "std::operator<");
    EXPECT_EQ(qualified_name("std::ostream& std::operator<< <char>(std::ostream&)"), "std::operator<<");
    EXPECT_EQ(qualified_name("A::operator->() const"), "A::operator->");
    EXPECT_EQ(qualified_name(""), "");
}

}
}
