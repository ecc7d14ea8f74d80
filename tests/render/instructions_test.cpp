#include <gtest/gtest.h>

#include <cstdio>

#include "support/printed.hpp"

namespace umbral::test {
namespace {

/// Instructions that draw_in_software executes in a program.
double instructions(const std::string& program)
{
    const Printed printed =
        run("valgrind --tool=callgrind --callgrind-out-file=/dev/null "
            "--toggle-collect='umbral::render::draw_in_software*' " +
            program);
    const std::string label = "Collected : ";
    const std::size_t at = printed.text.find(label);
    if (printed.status != 0 || at == std::string::npos) {
        ADD_FAILURE() << "valgrind did not count: " << printed.text;
        return 1;
    }
    return std::stod(printed.text.substr(at + label.size()));
}

// Effects that a scene does not call for cost no instructions, beside those that choose the kernel.
TEST(Instructions, of_absent_effects_are_within_two_percent_of_a_build_without_them)
{
    const double with = instructions(UMBRAL_WITH_EFFECTS);
    const double without = instructions(UMBRAL_WITHOUT_EFFECTS);
    EXPECT_GT(without, 1e6);
    EXPECT_NEAR(with / without, 1, 0.02) << with << " and " << without;
    // The kernel with all effects does ask for each, and the sources without them have nothing to ask.
    EXPECT_GT(instructions(UMBRAL_WITH_EFFECTS " all") / without, 1.02);
    EXPECT_NEAR(instructions(UMBRAL_WITHOUT_EFFECTS " all") / without, 1, 0.02);
    std::printf("instructions: %.0f with the effects in the sources, %.0f without, ratio %.4f\n", with, without,
                with / without);
}

}
}
