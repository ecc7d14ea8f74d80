#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <interaction/camera-animation/flights.hpp>
#include <limits>
#include <stdexcept>

#include "../view_errors.hpp"

// Linked with the reference; what is expected are the course's numbers, GLM's look-at in double, or a law.

using namespace umbral;
using namespace umbral::interaction;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

const CameraFlight quarter{{0, 1, 5}, {5, 1, 0}, {0, 0, 0}, {0, 1, 0}, 4};

/// Written by rows, as on paper.
void expect_rows(const glm::mat4& got, const glm::mat4& rows)
{
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_NEAR(got[column][row], rows[row][column], 5e-7) << "row " << row << ", column " << column;
}

}

TEST(CameraAnimation, numbers_of_problem_4_1)
{
    EXPECT_EQ(flight_pose(quarter, 2).eye, glm::vec3(2.5F, 1, 2.5F));
    EXPECT_EQ(flight_pose(quarter, 2).target, glm::vec3(0, 0.5F, 0));
    EXPECT_EQ(flight_pose(quarter, 1).eye, glm::vec3(1.25F, 1, 3.75F));
    expect_rows(flight_view(quarter, 2), {0.7071068F, 0, -0.7071068F, 0,                      //
                                          -0.0990148F, 0.9901475F, -0.0990148F, -0.4950738F,  //
                                          0.7001400F, 0.1400280F, 0.7001400F, -3.6407282F,    //
                                          0, 0, 0, 1});
    expect_rows(flight_view(quarter, 4), {0, 0, -1, 0, 0, 1, 0, -1, 1, 0, 0, -5, 0, 0, 0, 1});
}

TEST(CameraAnimation, stands_at_its_ends_exactly)
{
    constexpr std::uint64_t seed = 20501;
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const CameraFlight flight = random_flight(random, 1e5F);
        for (const float seconds : {0.0F, -0.0F, -1.0F, -infinity})
            ASSERT_EQ(flight_pose(flight, seconds).eye, flight.eye_from) << "seed " << seed;
        for (const float seconds : {flight.duration, 2 * flight.duration, infinity})
            ASSERT_EQ(flight_pose(flight, seconds).target, flight.target_to) << "seed " << seed;
    }
    CameraFlight cut = quarter;
    cut.duration = 0;
    EXPECT_EQ(flight_pose(cut, 0).eye, cut.eye_to);
    EXPECT_EQ(flight_pose(cut, -1e-30F).eye, cut.eye_from);
}

TEST(CameraAnimation, moves_evenly)
{
    constexpr std::uint64_t seed = 20502;
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        CameraFlight flight = random_flight(random);
        flight.duration = 8;
        for (int step = 1; step <= 8; ++step) {
            const auto time = static_cast<float>(step);
            const glm::vec3 way = flight_pose(flight, time).eye - flight_pose(flight, time - 1).eye;
            ASSERT_LE(distance(8.0F * way, flight.eye_to - flight.eye_from), 2e-5F) << "seed " << seed;
        }
    }
}

// GLM knows nothing of the degenerate cases, and random flights have none.
TEST(CameraAnimation, views_are_those_of_glm)
{
    constexpr std::uint64_t seed = 20503;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        CameraFlight flight = random_flight(random);
        const glm::vec3 place = i % 2 == 0 ? glm::vec3(0) : 5e5F * random.in_cube();
        for (glm::vec3* const end : {&flight.eye_from, &flight.eye_to, &flight.target_from, &flight.target_to})
            *end += place;
        const double u = double{random.uniform()};
        const auto seconds = static_cast<float>(u * double{flight.duration});
        const double part = double{seconds} / double{flight.duration};
        const glm::dvec3 eye = glm::mix(glm::dvec3(flight.eye_from), glm::dvec3(flight.eye_to), part);
        const glm::dvec3 target = glm::mix(glm::dvec3(flight.target_from), glm::dvec3(flight.target_to), part);
        const glm::mat4 expected(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
        const glm::mat4 got = flight_view(flight, seconds);
        ASSERT_LE(tests::rotation_error(got, expected), 2e-7) << "seed " << seed << ", flight " << i;
        ASSERT_LE(tests::translation_error(got, expected), 3e-7 * (1 + length(eye))) << "seed " << seed;
    }
}

TEST(CameraAnimation, degenerate_directions_have_a_view)
{
    const CameraFlight through{{0, 0, 4}, {0, 0, -4}, {0, 0, 0}, {0, 0, 0}, 2};
    expect_rows(flight_view(through, 1), glm::mat4(1));
    const CameraFlight over{{-2, 3, 0}, {2, 3, 0}, {0, 0, 0}, {0, 0, 0}, 2};
    // Looking down with x up, z lies to the right.
    expect_rows(flight_view(over, 1), {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, -3, 0, 0, 0, 1});
}

TEST(CameraAnimation, refuses_what_is_no_time)
{
    for (const float duration : {-1.0F, -1e-40F, no_number, infinity}) {
        CameraFlight flight = quarter;
        flight.duration = duration;
        EXPECT_THROW((void)flight_pose(flight, 1), std::invalid_argument) << duration;
        EXPECT_THROW((void)flight_view(flight, 1), std::invalid_argument) << duration;
    }
    EXPECT_THROW((void)flight_pose(quarter, no_number), std::invalid_argument);
    EXPECT_THROW((void)flight_view(quarter, no_number), std::invalid_argument);
}
