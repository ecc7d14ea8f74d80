#include "cli/unit_sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/temporary_folder.hpp"

// What was changed since a unit was built, so that no author tries a driver of before.
namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct SomeCourse {
    test::TemporaryFolder folder;
    Toolchain tools;
    Exercise unit;
    const fs::file_time_type before = fs::file_time_type::clock::now() - std::chrono::hours(10);
    const fs::file_time_type later = before + std::chrono::hours(1);

    SomeCourse()
    {
        tools.exercises = folder / "exercises";
        tools.reference = folder / "reference";
        tools.framework = folder / "framework";
        unit.folder = folder / "exercises/meshes/area";
        for (const char* file : files) add(file);
        for (const char* file : not_built) add(file);
    }

    void add(const std::string& file)
    {
        folder.write(file, "");
        fs::last_write_time(folder / file, before);
    }

    fs::file_time_type last_change(UnitParts parts) const
    {
        return std::max(last_shared_change(tools), last_own_change(unit, parts));
    }

    /// Whether a change of this file is seen.
    bool sees(const std::string& file, UnitParts parts)
    {
        fs::last_write_time(folder / file, later);
        const bool seen = last_change(parts) == later;
        fs::last_write_time(folder / file, before);
        EXPECT_EQ(last_change(parts), before);
        return seen;
    }

    static constexpr const char* files[] = {
        "exercises/meshes/area/driver.cpp",
        "exercises/meshes/area/exercise.json",
        "exercises/meshes/area/soups.hpp",
        "exercises/meshes/shared.hpp",
        "exercises/kit/shapes.hpp",
        "reference/meshes/area.cpp",
        "reference/wide.hpp",
        "framework/umbral/meshes/area.hpp",
        "framework/umbral/record/case.hpp",
    };
    static constexpr const char* not_built[] = {
        "exercises/meshes/area/README.md",
        "exercises/meshes/area/goal.png",
        "exercises/meshes/area/alternatives/a.cpp",
        "exercises/meshes/weld/driver.cpp",
        "exercises/lighting/shared.hpp",
    };
};

TEST(UnitSources, are_all_that_a_unit_is_built_from)
{
    SomeCourse course;
    for (const UnitParts parts : {UnitParts::answers, UnitParts::all}) {
        for (const char* file : SomeCourse::files) EXPECT_TRUE(course.sees(file, parts)) << file;
        for (const char* file : SomeCourse::not_built) EXPECT_FALSE(course.sees(file, parts)) << file;
    }
}

TEST(UnitSources, have_mistakes_only_where_these_are_built)
{
    SomeCourse course;
    course.add("exercises/meshes/area/mistakes/half.cpp");
    EXPECT_TRUE(course.sees("exercises/meshes/area/mistakes/half.cpp", UnitParts::all));
    EXPECT_FALSE(course.sees("exercises/meshes/area/mistakes/half.cpp", UnitParts::answers));
}

TEST(UnitSources, may_be_missing)
{
    EXPECT_EQ(last_shared_change({}), fs::file_time_type::min());
    EXPECT_EQ(last_own_change({}, UnitParts::all), fs::file_time_type::min());
}

}
}
