#include <gtest/gtest.h>

#include "mutants/mutants_table.hpp"
#include "mutants/unit_mutants.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

TEST(TryUnits, kills_what_the_checks_see_and_names_what_they_do_not)
{
    const Workbench bench;
    const std::filesystem::path finder = bench.tools().programs / "umbral-mutate";
    if (!std::filesystem::exists(finder)) GTEST_SKIP() << "libclang-14-dev is not installed: NO MUTANT WAS TRIED";
    Crew crew(bench.tools(), 2);
    std::vector<UnitMutants> units;
    // Shaders have no C++ to change.
    try_units(crew, MutantFamily::syntax, finder,
              std::vector{bench.exercise("raytracing/sphere"), bench.exercise("lighting/shaders")}, 0,
              [&](const UnitMutants& unit) { units.push_back(unit); });
    ASSERT_EQ(units.size(), 1U);
    const UnitMutants& sphere = units.front();
    EXPECT_EQ(sphere.trouble, "");
    EXPECT_EQ(sphere.file, "raytracing/sphere.cpp");
    EXPECT_TRUE(sphere.stale.empty()) << mutants_text(sphere);
    EXPECT_GE(sphere.mutants.size(), 50U);
    std::set<std::string> killed;
    std::set<std::string> alive;
    for (const TriedMutant& one : sphere.mutants) {
        (one.trial.killed ? killed : alive).insert(one.mutant.change);
        EXPECT_EQ(one.trial.killed, !one.trial.by.empty()) << one.mutant.change;
    }
    EXPECT_TRUE(killed.contains("discriminant < 0 → discriminant <= 0"));
    EXPECT_TRUE(killed.contains("ray.origin - sphere.centre → ray.origin + sphere.centre"));
    EXPECT_TRUE(alive.contains("discriminant < 0 → false"));
}

TEST(TryUnits, kills_the_slips_that_the_checks_see)
{
    const Workbench bench;
    const std::filesystem::path finder = bench.tools().programs / "umbral-mutate";
    if (!std::filesystem::exists(finder)) GTEST_SKIP() << "libclang-14-dev is not installed: NO SLIP WAS TRIED";
    Crew crew(bench.tools(), 2);
    std::set<std::string> killed;
    try_units(crew, MutantFamily::slips, finder,
              std::vector{bench.exercise("meshes/area"), bench.exercise("raytracing/sphere")}, 0,
              [&](const UnitMutants& unit) {
                  EXPECT_EQ(unit.trouble, "");
                  for (const TriedMutant& one : unit.mutants)
                      if (one.trial.killed) killed.insert(one.mutant.change);
              });
    // What depends on more than sizes cannot be answered by them.
    EXPECT_TRUE(killed.contains("surface_area(mesh) → what it answered to arguments of the same sizes and numbers"));
    EXPECT_TRUE(killed.contains("ray.t_min < t → ray.t_min - 1e-4F < t"));
    EXPECT_TRUE(killed.contains("ray.t_max → ray.t_min"));
}

// Only trusted libraries hold mutants: a number given to another one is our fault, and changes nothing.
TEST(TryUnits, a_library_without_mutants_has_none_to_choose)
{
    const Workbench bench;
    const Built built = bench.build_sphere(sphere_with("extern \"C\" { int umbral_mutant_chosen = 0; }\n", ""));
    ASSERT_EQ(to_string(built.verdict), "ok") << built.message;
    Spawner spawner(bench.spawner());
    RunRequest request = bench.sphere_run(built.library);
    EXPECT_EQ(to_string(spawner.run(request).verdict), "ok");
    request.mutant = 1;
    const RunOutcome outcome = spawner.run(request);
    EXPECT_NE(to_string(outcome.verdict), "ok");
}

}
}
