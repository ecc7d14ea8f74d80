#include "build/header_texts.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

TEST(DeclaredName, is_the_last_of_a_qualified_one)
{
    EXPECT_EQ(declared_name("rotate(mat<4, 4, T, Q> const& m)"), "rotate");
    EXPECT_EQ(declared_name("rotateNormalizedAxis"), "rotateNormalizedAxis");
    EXPECT_EQ(declared_name("mat<4, 4, T, Q>::operator[](int)"), "operator");
    EXPECT_EQ(declared_name("operator<(A, B)"), "operator");
    EXPECT_EQ(declared_name("a::b<c<d>, e>::f()"), "f");
    EXPECT_EQ(declared_name("~vec()"), "~vec");
    EXPECT_EQ(declared_name("open<never"), "open");
    EXPECT_EQ(declared_name("(x)"), "");
    EXPECT_EQ(declared_name(""), "");
}

TEST(HeaderTexts, know_what_a_macro_renamed)
{
    const umbral::test::TemporaryFolder folder;
    const std::string file = folder.path() / "vector.inl";
    std::ofstream(file) << "template <class T>\n\tT reflect(T const& I, T const& N)\n\tT& T::operator*=(T)\n";
    HeaderTexts texts;
    EXPECT_TRUE(texts.declares({"glm::reflect<float>", file, 2, 4, "reflect"}));
    EXPECT_TRUE(texts.declares({"glm::T::operator*=<float>", file, 3, 5, "operator*="}));
    EXPECT_TRUE(texts.declares({"glm::T::~T()", file, 1, 1, "~T"}));
    // Of what stands in the line only the function's own name counts.
    EXPECT_FALSE(texts.declares({"glm::N<float>", file, 2, 4, "N"}));
    EXPECT_FALSE(texts.declares({"glm::operator+<float>", file, 2, 4, "operator+"}));
    EXPECT_FALSE(texts.declares({"glm::reflect", file, 9, 4, "reflect"}));
    EXPECT_FALSE(texts.declares({"glm::reflect", file, 2, 400, "reflect"}));
    EXPECT_FALSE(texts.declares({"glm::reflect", file, 0, 0, "reflect"}));
    EXPECT_FALSE(texts.declares({"glm::reflect", "/dev/zero", 1, 1, "reflect"}));
    EXPECT_FALSE(texts.declares({"glm::reflect", folder.path(), 1, 1, "reflect"}));
}

// Debug information says what hostile sources wrote behind #line.
TEST(HeaderTexts, are_not_read_without_end)
{
    const umbral::test::TemporaryFolder folder;
    const auto header = [&](const char* name) {
        std::ofstream stream(folder.path() / name);
        stream << "float reflect();\n" << std::string(std::size_t{5} << 20U, '/');
        return (folder.path() / name).string();
    };
    const std::string one = header("one.inl");
    const std::string other = header("other.inl");
    HeaderTexts texts;
    const auto declares = [&](const std::string& file) { return texts.declares({"f", file, 1, 7, "reflect"}); };
    EXPECT_TRUE(declares(one));
    EXPECT_FALSE(declares(other));
}

}
}
