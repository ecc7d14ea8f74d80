#include "inspect/demangle.hpp"

#include <gtest/gtest.h>

namespace umbral::grader::test {
namespace {

TEST(Demangled, is_what_cpp_writes)
{
    EXPECT_EQ(demangled("_ZN6umbral10raytracing9intersectERKNS_3RayE", 1000),
              "umbral::raytracing::intersect(umbral::Ray const&)");
    EXPECT_EQ(demangled("printf", 1000), "printf");
    EXPECT_EQ(demangled("", 1000), "");
    EXPECT_EQ(demangled("_Z", 1000), "_Z");
}

TEST(Demangled, is_cut_at_the_limit)
{
    EXPECT_EQ(demangled("_ZN3foo3barEi", 5), "foo::");
    EXPECT_EQ(demangled("not_mangled_at_all", 5), "not_m");
}

// f(P<P<P<…>, P<…>>, …>): each level doubles the text, and adds a few letters to the name.
TEST(Demangled, takes_no_longer_for_names_that_stand_for_gigabytes)
{
    std::string name = "_Z1fP";
    constexpr int levels = 60;
    for (int i = 0; i < levels; ++i) name += i == 0 ? "1PI" : "S_I";
    name += "iiE";
    for (int i = 1; i < levels; ++i) {
        const int at = i - 1;
        name += "S";
        if (at >= 36) name += "0";
        name += at % 36 < 10 ? static_cast<char>('0' + at % 36) : static_cast<char>('A' + at % 36 - 10);
        name += "_E";
    }
    const std::string text = demangled(name.c_str(), 256);
    EXPECT_EQ(text.size(), 256U);
}

TEST(Demangled, depth_does_not_overflow_the_stack)
{
    const std::string name = "_Z1f" + std::string(1'000'000, 'P') + "i";
    EXPECT_LE(demangled(name.c_str(), 256).size(), 256U);
}

}
}
