#include "bench/judges/resolutions.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

MeasuredPair pair(const char* change, bool harmful, bool visible, double worst)
{
    MeasuredPair made;
    made.scene = "ball";
    made.change = change;
    made.harmful = harmful;
    made.invisible = harmful && !visible;
    made.ours.worst = worst;
    return made;
}

TEST(Resolutions, count_the_bugs_that_the_largest_size_shows)
{
    const JudgedSize large{256,
                           4,
                           {pair("hole", true, true, 3), pair("crack", true, true, 0.5),
                            pair("nothing to see", true, false, 0), pair("other order", false, true, 0.2)}};
    const JudgedSize small{64,
                           0.5,
                           {pair("hole", true, true, 2), pair("crack", true, false, 0),
                            pair("nothing to see", true, true, 9), pair("other order", false, true, 1.5)}};
    const std::string table = resolution_table(std::vector{small, large});
    EXPECT_NE(table.find("| 64 | 0.50 ms | 1 of 2 (50.0 %) | 1 (50.0 %) | 1 of 1 |"), std::string::npos) << table;
    EXPECT_NE(table.find("| 256 | 4.00 ms | 2 of 2 (100.0 %) | 1 (50.0 %) | 0 of 1 |"), std::string::npos) << table;
}

TEST(Resolutions, of_nothing_are_a_heading) { EXPECT_EQ(resolution_table({}).find("| side"), 0U); }

}
}
