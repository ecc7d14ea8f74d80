#include "collect/roster.hpp"

#include <gtest/gtest.h>

namespace umbral::grader::test {
namespace {

// As spreadsheets write it where numbers have commas.
TEST(Roster, may_have_semicolons)
{
    const auto entries = parse_roster("folder;id;name\r\nGarcía, Ana;s1;\"Ana; García\"\r\n", "roster.csv");
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].folder, "García, Ana");
    EXPECT_EQ(entries[0].id, "s1");
    EXPECT_EQ(entries[0].name, "Ana; García");
}

}
}
