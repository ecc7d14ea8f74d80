#include <gtest/gtest.h>

#include <umbral/core/random.hpp>
#include <umbral/interaction/pick_ray.hpp>

// Linked with the reference; what is expected was worked out by hand, or follows from a law.

using namespace umbral;
using namespace umbral::interaction;

TEST(PickRay, KnownAnswers)
{
    EXPECT_EQ(pick_ray_point({0, 0, 0}, {4, 8, 2}, 0.25F), glm::vec3(1, 2, 0.5F));
    EXPECT_EQ(pick_ray_point({1, 2, 3}, {1, 2, 3}, 0.5F), glm::vec3(1, 2, 3));
}

TEST(PickRay, IsExactAtBothEnds)
{
    Random random(20301);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = 1000.0F * random.in_cube();
        const glm::vec3 b = 0.001F * random.in_cube();
        EXPECT_EQ(pick_ray_point(a, b, 0), a);
        EXPECT_EQ(pick_ray_point(a, b, 1), b);
    }
}
