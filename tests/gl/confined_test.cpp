#include <gtest/gtest.h>

#include "support/workbench.hpp"
#include "worker/worker.hpp"

// Drawing in a run as every student's: a fork of a warm spawner, behind Landlock and seccomp.
namespace umbral::grader::test {
namespace {

RunOutcome run_shaders(const Workbench& bench, const std::string& back_end, const std::string& case_name)
{
    Spawner spawner(bench.tools().programs / "umbral-spawner-gl", back_end);
    EXPECT_TRUE(spawner.gl().starts_with(back_end == "egl" ? "EGL: " : "OSMesa: ")) << spawner.gl();
    RunRequest request;
    request.driver = unit_folder(bench.tools(), "lighting/shaders") / "driver.so";
    for (const char* file : {"phong.vert", "phong.frag"})
        request.sources[file] = project_file(std::string("reference/lighting/shaders/") + file);
    request.case_name = case_name;
    request.stream = 7;
    request.limits = {.wall_seconds = 60, .memory_mib = 512};
    return spawner.run(request);
}

TEST(Confined, both_back_ends_draw_the_same_in_the_sandbox)
{
    const Workbench bench;
    for (const char* case_name : {"pictures", "random"}) {
        const RunOutcome osmesa = run_shaders(bench, "osmesa", case_name);
        const RunOutcome egl = run_shaders(bench, "egl", case_name);
        EXPECT_EQ(osmesa.verdict, Verdict::ok) << osmesa.message;
        EXPECT_EQ(egl.verdict, Verdict::ok) << egl.message;
        EXPECT_EQ(egl.refused, std::vector<std::string>{});
        EXPECT_EQ(egl.output, "");
        EXPECT_GT(egl.recording.tensors.size(), 1U);
        EXPECT_EQ(egl.recording.tensors, osmesa.recording.tensors) << case_name;
    }
}

TEST(Confined, an_unknown_back_end_does_not_start)
{
    const Workbench bench;
    EXPECT_THROW(Spawner(bench.tools().programs / "umbral-spawner-gl", "vulkan"), std::runtime_error);
}

}
}
