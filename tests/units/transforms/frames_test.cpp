#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/transforms/frames.hpp>

// Linked with the reference; what is expected follows from what coordinates are: origin + a x + b y + c z is the same
// point in every frame.

using namespace umbral;
using namespace umbral::transforms;

namespace {

Frame any_frame(float far, Random& random)
{
    Frame frame{random.in_cube(), random.in_cube(), random.in_cube(), far * random.in_cube()};
    for (int i = 0; i < 3; ++i) (i == 0 ? frame.x : i == 1 ? frame.y : frame.z)[i] += 2;
    return frame;
}

// From the world's origin moved to `near`, in double.
glm::dvec3 point_at(const Frame& frame, const glm::dvec4& coordinates, const glm::dvec3& near)
{
    return coordinates.x * glm::dvec3(frame.x) + coordinates.y * glm::dvec3(frame.y) +
           coordinates.z * glm::dvec3(frame.z) + (glm::dvec3(frame.origin) - near);
}

}

TEST(Frames, known_answers)
{
    const Frame quarter{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {3, 4, 0}};
    EXPECT_EQ(inverse_of_cartesian(quarter) * glm::vec4(0, 0, 0, 1), glm::vec4(-4, 3, 0, 1));
    EXPECT_EQ(inverse_of_cartesian(quarter), inverse_of_frame(quarter));
    EXPECT_EQ(frame_matrix(quarter) * glm::vec4(-4, 3, 0, 1), glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(classify_frame(quarter), FrameKind::cartesian);
    EXPECT_EQ(classify_frame({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}}), FrameKind::orthonormal)
        << "the course's criterion for the plane: 0 = 0";
    EXPECT_EQ(classify_frame({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}), FrameKind::orthogonal);
    EXPECT_EQ(classify_frame({{2, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0, 0}}), FrameKind::oblique);
    EXPECT_EQ(classify_frame({{2, 0, 0}, {1, 1, 0}, {3, 1, 0}, {0, 0, 0}}), FrameKind::degenerate);
}

TEST(Frames, same_point_in_both_frames)
{
    constexpr std::uint64_t seed = 20291;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const float far = std::pow(10.0F, random.uniform(0, 7));
        const Frame from = any_frame(far, random);
        Frame to = any_frame(1, random);
        to.origin += from.origin;
        const glm::dmat4 m(between_frames(from, to));
        const glm::dvec4 coordinates(random.in_cube(), 1);
        const glm::dvec3 expected = point_at(from, coordinates, glm::dvec3(to.origin));
        ASSERT_LE(length(point_at(to, m * coordinates, glm::dvec3(to.origin)) - expected), 1e-4)
            << "seed " << seed << ", frames " << i;
    }
}

// All large products cancel, and 1e-60 of them is left; with another component 0, nothing.
TEST(Frames, orientation_is_exact_however_little_is_left)
{
    const Frame frame{{1e20F, 1e20F, 0}, {1, 1, 1e-30F}, {1e-30F, 0, 1}, {0, 0, 0}};
    EXPECT_EQ(orientation(frame), 1);
    EXPECT_EQ(orientation({frame.y, frame.x, frame.z, frame.origin}), -1);
    EXPECT_EQ(orientation({frame.x, frame.y, {1e-30F, 1e-30F, 1}, frame.origin}), 0);
    // The least and the largest floats.
    EXPECT_EQ(orientation({{1e-45F, 0, 0}, {0, 0, 1e-45F}, {0, 1e-45F, 0}, {0, 0, 0}}), -1);
    EXPECT_EQ(orientation({{3e38F, 3e38F, 0}, {3e38F, 3e38F, 1e-45F}, {1e-45F, 0, 3e38F}, {0, 0, 0}}), 1);
}

// z = x + y exactly, of numbers with 23 bits: the determinant is 0; a unit in the last place decides otherwise.
TEST(Frames, orientation_is_exact)
{
    constexpr std::uint64_t seed = 20292;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        Frame frame{};
        for (int k = 0; k < 3; ++k) {
            frame.x[k] = 0.5F + 0x1p-23F * static_cast<float>(random.below(1U << 22U));
            frame.y[k] = 0.5F + 0x1p-23F * static_cast<float>(random.below(1U << 22U));
        }
        frame.z = frame.x + frame.y;
        ASSERT_EQ(orientation(frame), 0) << "seed " << seed << ", frame " << i;
        // det [x y (x + y + e)] is the component of x × y along e.
        const double component = double{frame.x.x} * double{frame.y.y} - double{frame.x.y} * double{frame.y.x};
        frame.z.z += 0x1p-22F;
        ASSERT_EQ(orientation(frame), component > 0 ? 1 : component < 0 ? -1 : 0) << "seed " << seed << ", frame " << i;
    }
}
