#include <gtest/gtest.h>

#include <cstdio>
#include <pipeline/software-pipeline/scenes.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/program.hpp>

#include "drawn_by_mesa.hpp"

// The same calls by the reference and by OpenGL, which Mesa draws: two pipelines that share no line.
namespace umbral::pipeline {
namespace {

struct Tally {
    std::size_t pixels = 0;    ///< that either changed
    std::size_t coverage = 0;  ///< that one alone changed
    std::size_t colors = 0;    ///< both, in colours more than 0.01 apart
    std::size_t depths = 0;  ///< whose depths are more than 0.0004 apart: Mesa interpolates from positions that are not
                             ///< rounded to 1/256 pixel
    std::size_t only_here = 0;

    [[nodiscard]] std::size_t different() const { return coverage + colors + depths; }
};

class SoftwarePipeline : public testing::Test {
protected:
    static constexpr std::uint64_t seed = 20701;
    Random random{seed};

    SoftwarePipeline()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        program_.emplace(gl::ShaderSource{"call.vert", vertex_text}, gl::ShaderSource{"call.frag", fragment_text});
    }

    void compare(const Call& call, Tally& tally)
    {
        Recorder out;
        const Layer ours = drawn(out, call);
        const Layer theirs = drawn_by_mesa(call, *program_);
        for (std::size_t i = 0; i < ours.colors.cells.size(); ++i) {
            const bool here = ours.colors.cells[i] != untouched;
            const bool there = theirs.colors.cells[i] != untouched;
            tally.pixels += here || there ? 1U : 0U;
            tally.coverage += here != there ? 1U : 0U;
            tally.only_here += here && !there ? 1U : 0U;
            if (here != there) continue;
            const glm::vec3 apart = abs(ours.colors.cells[i] - theirs.colors.cells[i]);
            tally.colors += std::max({apart.r, apart.g, apart.b}) > 0.01F ? 1U : 0U;
            tally.depths += std::abs(ours.depths.cells[i] - theirs.depths.cells[i]) > 4e-4F ? 1U : 0U;
        }
    }

    template <class Make>
    Tally compare_many(const char* name, int count, const Make& make)
    {
        Tally tally;
        for (int i = 0; i < count; ++i) compare(make(i), tally);
        std::printf("%-24s %8zu pixels; differ in coverage %zu (here only %zu), colour %zu, depth %zu\n", name,
                    tally.pixels, tally.coverage, tally.only_here, tally.colors, tally.depths);
        return tally;
    }

private:
    std::optional<gl::OffscreenContext> context_;
    std::optional<gl::Program> program_;
};

/// Pictures of 96 x 72 pixels, so that most pixels lie inside.
Call larger(Call call)
{
    call.width = call.state.viewport.width = 96;
    call.height = call.state.viewport.height = 72;
    return call;
}

}

TEST_F(SoftwarePipeline, triangles_in_front_are_mesas)
{
    const Tally tally = compare_many("in front", 300, [&](int) { return larger(in_front(random, 6)); });
    EXPECT_LE(2000 * tally.different(), tally.pixels) << "seed " << seed;
}

TEST_F(SoftwarePipeline, triangles_about_the_camera_are_mesas)
{
    const Tally tally = compare_many("about the camera", 300, [&](int) { return larger(about_the_camera(random, 5)); });
    EXPECT_LE(2000 * tally.different(), tally.pixels) << "seed " << seed;
}

TEST_F(SoftwarePipeline, culling_and_flat_colours_are_mesas)
{
    const Tally tally = compare_many("culling, flat", 300, [&](int i) {
        Call call = larger(i % 2 == 0 ? in_front(random, 6) : about_the_camera(random, 6));
        call.state.culling = static_cast<Culling>(i % 3);
        call.state.shading = ShadeModel::flat;
        return call;
    });
    EXPECT_LE(2000 * tally.different(), tally.pixels) << "seed " << seed;
}

TEST_F(SoftwarePipeline, depth_functions_formats_and_ranges_are_mesas)
{
    const Tally tally = compare_many("depth", 480, [&](int i) {
        Call call = larger(in_front(random, 8));
        call.state.depth.function = static_cast<DepthFunction>(i % 8);
        call.state.depth.format = static_cast<DepthFormat>(i % 3);
        call.state.depth.writes = i % 5 != 4;
        call.state.depth.enabled = i % 11 != 10;
        const bool reversed = i % 2 == 1;
        call.state.viewport.near_depth = reversed ? 1 : 0.25F;
        call.state.viewport.far_depth = reversed ? 0 : 0.75F;
        call.clear_depth = stored_depth(call.state.depth.format, reversed ? 0.1F : 0.7F);
        return call;
    });
    EXPECT_LE(1000 * tally.different(), tally.pixels) << "seed " << seed;
}

TEST_F(SoftwarePipeline, viewports_are_mesas)
{
    const Tally tally = compare_many("viewports", 300, [&](int i) {
        Call call = larger(i % 2 == 0 ? in_front(random, 5) : about_the_camera(random, 5));
        call.state.viewport.left = static_cast<int>(random.below(60)) - 30;
        call.state.viewport.top = static_cast<int>(random.below(60)) - 30;
        call.state.viewport.width = 20 + static_cast<int>(random.below(90));
        call.state.viewport.height = 20 + static_cast<int>(random.below(90));
        return call;
    });
    EXPECT_LE(2000 * tally.different(), tally.pixels) << "seed " << seed;
}

// OpenGL leaves implementations some freedom in lines; points are what they are.
TEST_F(SoftwarePipeline, lines_and_points_are_nearly_mesas)
{
    for (const PolygonMode mode : {PolygonMode::line, PolygonMode::point})
        for (const bool clipped : {false, true}) {
            const std::string name =
                std::string(mode == PolygonMode::line ? "lines" : "points") + (clipped ? ", clipped" : "");
            const Tally tally = compare_many(name.c_str(), 200, [&](int) {
                Call call = larger(clipped ? about_the_camera(random, 4) : in_front(random, 4));
                call.state.mode = mode;
                return call;
            });
            EXPECT_LE(20 * tally.different(), tally.pixels) << name << ", seed " << seed;
        }
}

// Two triangles that share a side, clipped or not: with "always" and colours that say which, no pixel is drawn twice or
// left out.
TEST_F(SoftwarePipeline, sides_leave_no_gap_and_no_pixel_twice)
{
    std::size_t covered = 0;
    for (int round = 0; round < 400; ++round) {
        Call one = about_the_camera(random, 2);
        one.vertices.resize(4);
        one.triangles = {{0, 1, 2}};
        Call other = one;
        other.triangles = {{2, 1, 3}};
        Call both = one;
        both.triangles = {{0, 1, 2}, {2, 1, 3}};
        // Only where they lie on different sides of what they share do they not overlap: told by culling, both show the
        // same face.
        const auto count = [](const Call& call) {
            Recorder out;
            const Layer layer = drawn(out, call);
            return std::count_if(layer.colors.cells.begin(), layer.colors.cells.end(),
                                 [](const glm::vec3& color) { return color != untouched; });
        };
        for (const Culling culling : {Culling::back, Culling::front}) {
            one.state.culling = other.state.culling = both.state.culling = culling;
            const auto sum = count(one) + count(other);
            ASSERT_EQ(count(both), sum) << "seed " << seed << ", round " << round;
            covered += static_cast<std::size_t>(sum);
        }
    }
    EXPECT_GT(covered, 20'000U);
}

TEST_F(SoftwarePipeline, nonsense_draws_nothing)
{
    for (const float number : {std::nanf(""), INFINITY, -INFINITY, 3e38F}) {
        for (int mode = 0; mode < 3; ++mode) {
            Call call = in_front(random, 2);
            call.state.mode = static_cast<PolygonMode>(mode);
            for (std::size_t i = 0; i < 6; i += 3) call.vertices[i].position.x = number;
            Recorder out;
            const Layer layer = drawn(out, call);
            if (number < 1e38F || number == INFINITY) {
                EXPECT_TRUE(std::all_of(layer.colors.cells.begin(), layer.colors.cells.end(),
                                        [](const glm::vec3& color) { return color == untouched; }));
            }
        }
    }
}

}
