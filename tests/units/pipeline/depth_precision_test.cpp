#include "depth_precision_functions.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <umbral/core/random.hpp>

using namespace umbral;
using namespace umbral::pipeline;

namespace {

constexpr DepthRange course_near{0.2, 400};
constexpr DepthRange course_far{0.01, 1000};
constexpr double infinity = std::numeric_limits<double>::infinity();

const DepthPrecision& oracle()
{
    void* module = dlopen(ORACLE_MODULE, RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) throw std::runtime_error(std::string("expected the oracle's module: ") + dlerror());
    return *reinterpret_cast<const DepthPrecision*>(reinterpret_cast<void* (*)()>(dlsym(module, "unit_entry"))());
}

double relative(double got, double exact) { return got == exact ? 0 : std::abs(got - exact) / std::abs(exact); }

}

// The course's numbers, with the signs that it lacks, and those worked out from its formulas with many digits.
TEST(DepthPrecision, course_values)
{
    EXPECT_LT(relative(eye_depth(course_near, 1, 16), -0.200003050324998853), 1e-15);
    EXPECT_LT(relative(eye_depth(course_near, 65534, 16), -388.160037906832), 1e-14);
    EXPECT_LT(relative(eye_depth(course_far, 1, 16), -0.01000015259102143), 1e-15);
    EXPECT_LT(relative(eye_depth(course_far, 65534, 16), -395.900540070318), 1e-14);
    EXPECT_NEAR(65535 * window_depth(course_near, -1), 52454.227, 1e-3);
    EXPECT_NEAR(65535 * window_depth(course_near, -388), 65533.986, 1e-3);
    EXPECT_NEAR(65535 * window_depth(course_far, -999), 65534.99934, 1e-5);
    EXPECT_EQ(depth_code(window_depth(course_far, -304.0), 16), 65533U)
        << "rounded, the last code but one begins beyond 304";
    EXPECT_EQ(depth_code(window_depth(course_far, -304.1), 16), 65534U);
    EXPECT_EQ(depth_code(window_depth(course_far, -567.2), 16), 65534U);
    EXPECT_EQ(depth_code(window_depth(course_far, -567.3), 16), 65535U);
}

TEST(DepthPrecision, planes_are_the_ends)
{
    for (const DepthRange& range : {course_near, course_far, DepthRange{1, 2}}) {
        EXPECT_EQ(ndc_depth(range, -range.near_plane), -1);
        EXPECT_NEAR(ndc_depth(range, -range.far_plane), 1, 1e-15);
        EXPECT_EQ(window_depth({range.near_plane, range.far_plane, true}, -range.far_plane), 0);
        for (const int bits : {1, 16, 32}) {
            EXPECT_EQ(eye_depth(range, 0, bits), -range.near_plane);
            EXPECT_LT(relative(eye_depth(range, depth_code(1, bits), bits), -range.far_plane), 1e-15);
        }
    }
    EXPECT_EQ(eye_depth({1, infinity}, 255, 8), -infinity);
    EXPECT_EQ(window_depth({1, infinity, true}, -4), 0.25);
}

// Every code leads to a place with that code.
TEST(DepthPrecision, there_and_back)
{
    for (const bool reversed : {false, true})
        for (std::uint32_t code = 0; code <= 65535; ++code) {
            const DepthRange range{0.01, 1000, reversed};
            ASSERT_EQ(depth_code(window_depth(range, eye_depth(range, code, 16)), 16), code);
        }
}

// The definition itself: one step apart in depth, exactly there.
TEST(DepthPrecision, fighting_begins_where_depths_differ_by_a_step)
{
    constexpr std::uint64_t seed = 20311;
    Random random(seed);
    int found = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double n = std::exp2(-8 * random.uniform_double());
        const DepthRange range{n, n * std::exp2(1 + 15 * random.uniform_double())};
        const double gap = n * std::exp2(random.uniform(-6, 6));
        const std::optional<double> begin = fighting_distance(range, 12, gap);
        if (!begin || *begin == n) continue;
        ++found;
        const double steps = 4095 * (window_depth(range, -*begin - gap) - window_depth(range, -*begin));
        ASSERT_NEAR(steps, 1, 1e-8) << "seed " << seed << ", camera " << i;
    }
    EXPECT_GT(found, 2'000);
    EXPECT_EQ(fighting_distance(course_far, 24, 1e-10), 0.01) << "from the near plane on";
    EXPECT_EQ(fighting_distance(course_far, 24, 900), std::nullopt);
}

// n = 0.01, f = 1000: a step of each format, to two digits.
TEST(DepthPrecision, resolution_of_the_formats)
{
    const DepthRange reversed{0.01, 1000, true};
    const auto is = [](double got, double expected) { EXPECT_LT(relative(got, expected), 0.04); };
    is(depth_resolution(course_far, DepthFormat::unorm16, -1), 0.0015);
    is(depth_resolution(course_far, DepthFormat::unorm16, -100), 15.3);
    is(depth_resolution(course_far, DepthFormat::unorm24, -100), 0.0596);
    is(depth_resolution(course_far, DepthFormat::float32, -500), 1.49);
    is(depth_resolution(reversed, DepthFormat::float32, -0.1), 7.5e-9);
    is(depth_resolution(reversed, DepthFormat::float32, -10), 1.2e-6);
    is(depth_resolution(reversed, DepthFormat::float32, -500), 2.3e-5);
}

// The header's guarantees.
TEST(DepthPrecision, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20312;
    Random random(seed);
    const DepthPrecision& exact = oracle();
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double n = std::pow(10, 2 - 4 * random.uniform_double());
        const double f = i % 5 == 0 ? infinity : n * std::pow(10, 0.1 + 14 * random.uniform_double());
        const double beside = std::pow(10, -10 * random.uniform_double());
        const bool reversed = random.below(2) == 0;
        const DepthRange range{n, f, reversed};
        const double z =
            reversed ? (std::isinf(f) ? -n / beside : -std::max(n, f * (1 - beside))) : -std::min(f, n * (1 + beside));
        const int bits = 1 + static_cast<int>(random.below(32));
        const auto last = static_cast<std::uint32_t>((std::uint64_t{1} << static_cast<unsigned>(bits)) - 1);
        const std::uint32_t code = i % 2 == 0 ? random.bits() & last : last - std::min(last, 1 + random.below(50));
        const double gap = n * std::exp2(random.uniform(-20, 20));
        worst = std::max({worst, relative(window_depth(range, z), exact.window_depth(range, z)),
                          relative(eye_depth(range, code, bits), exact.eye_depth(range, code, bits)),
                          relative(depth_resolution(range, DepthFormat::unorm24, -2 * n),
                                   exact.depth_resolution(range, DepthFormat::unorm24, -2 * n))});
        const std::optional<double> got = fighting_distance(range, bits, gap);
        const std::optional<double> begin = exact.fighting_distance(range, bits, gap);
        ASSERT_EQ(got.has_value(), begin.has_value()) << "seed " << seed << ", camera " << i;
        if (got) worst = std::max(worst, relative(*got, *begin));
        ASSERT_LT(worst, 1e-15) << "seed " << seed << ", camera " << i;
    }
    RecordProperty("relative", std::to_string(worst * 1e16) + "e-16");
}
