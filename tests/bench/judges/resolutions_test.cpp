#include "bench/judges/resolutions.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

TEST(Resolutions, count_the_bugs_that_the_largest_size_shows)
{
    JudgedSize large{256, 4};
    large.pairs[{"ball", "hole"}] = {true, true, 3};
    large.pairs[{"ball", "crack"}] = {true, true, 0.5};
    large.pairs[{"ball", "nothing to see"}] = {true, false, 0};
    large.pairs[{"ball", "other order"}] = {false, true, 0.2};
    JudgedSize small{64, 0.5};
    small.pairs[{"ball", "hole"}] = {true, true, 2};
    small.pairs[{"ball", "crack"}] = {true, false, 0};
    small.pairs[{"ball", "nothing to see"}] = {true, true, 9};
    small.pairs[{"ball", "other order"}] = {false, true, 1.5};
    const std::string table = resolution_table(std::vector{small, large});
    EXPECT_NE(table.find("| 64 | 0.50 ms | 1 of 2 (50.0 %) | 1 (50.0 %) | 1 of 1 |"), std::string::npos) << table;
    EXPECT_NE(table.find("| 256 | 4.00 ms | 2 of 2 (100.0 %) | 1 (50.0 %) | 0 of 1 |"), std::string::npos) << table;
}

TEST(Resolutions, of_nothing_are_a_heading) { EXPECT_EQ(resolution_table({}).find("| side"), 0U); }

}
}
