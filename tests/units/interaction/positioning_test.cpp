#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/interaction/positioning.hpp>

namespace umbral::interaction {
namespace {

// The course's numbers, worked by hand.
TEST(Positioning, the_courses_example)
{
    const glm::dvec2 place = pixel_in_world({100, 50}, {-2, 2, -1.5, 1.5}, {800, 600});
    EXPECT_NEAR(place.x, -1.4975, 1e-15);
    EXPECT_NEAR(place.y, 1.2475, 1e-15);
}

TEST(Positioning, cursors_outside_lie_in_negative_pixels)
{
    EXPECT_EQ(cursor_pixel({-0.25, 0.25}, {10, 10}, {20, 20}), glm::ivec2(-1, 0));
    EXPECT_EQ(cursor_pixel({9.75, 10}, {10, 10}, {20, 20}), glm::ivec2(19, 20));
    EXPECT_FALSE(cursor_pixel({1, 1}, {10, 0}, {20, 0}));
}

TEST(Positioning, angles_are_counter_clockwise_and_left_is_plus_pi)
{
    EXPECT_NEAR(entered_angle({320, 240}, {330, 230}).value(), std::numbers::pi / 4, 1e-15);
    EXPECT_EQ(entered_angle({5, 5}, {4, 5}).value(), std::numbers::pi);
    EXPECT_FALSE(entered_angle({5, 5}, {5, 5}));
}

TEST(Positioning, linked_views_agree_with_cameras_and_keep_what_they_do_not_show)
{
    struct Look {
        LinkedView view;
        glm::dvec3 from;
        glm::dvec3 up;
    };
    const glm::dvec3 cursor(1, 2, 3);
    for (const auto& [view, from, up] :
         {Look{LinkedView::front, {0, 0, 1}, {0, 1, 0}}, Look{LinkedView::top, {0, 1, 0}, {0, 0, -1}},
          Look{LinkedView::side, {1, 0, 0}, {0, 1, 0}}}) {
        const glm::dvec4 seen = glm::lookAt(from, glm::dvec3(0), up) * glm::dvec4(cursor, 1);
        EXPECT_NEAR(glm::length(glm::dvec2(seen) - cursor_in_view(view, cursor)), 0, 1e-15);
        const glm::dvec3 moved = cursor_from_view(view, {7, 8}, cursor);
        EXPECT_EQ(cursor_in_view(view, moved), glm::dvec2(7, 8));
        EXPECT_EQ(glm::dot(moved, from), glm::dot(cursor, from));
        EXPECT_EQ(cursor_from_view(view, cursor_in_view(view, cursor), cursor), cursor);
    }
}

/// GLM's own way there: what the answer is projected to must be the pixel's centre again, and it must lie in the plane.
TEST(Positioning, points_on_planes_are_projected_to_their_pixels)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const glm::mat4 view = glm::lookAt(5.0F * random.in_cube() + glm::vec3(0, 0, 9), random.in_cube(), {0, 1, 0});
        const glm::mat4 projection = seed % 3 == 0 ? glm::ortho(-3.0F, 5.0F, -2.0F, 4.0F, 0.5F, 50.0F)
                                                   : glm::perspective(0.9F, 1.5F, 0.25F, 100.0F);
        const glm::ivec2 size(300, 200);
        const glm::ivec2 pixel(random.below(300), random.below(200));
        const SnapPlane plane{glm::dvec3(random.in_cube()), random.uniform(-3, 3)};
        const auto point = point_on_plane(pixel, size, view, projection, plane);
        if (!point) continue;
        ++found;
        const double scale = glm::length(plane.normal) * (1 + glm::length(*point));
        EXPECT_NEAR(glm::dot(plane.normal, *point), plane.offset, 1e-9 * scale);
        const glm::dvec3 window =
            glm::project(*point, glm::dmat4(view), glm::dmat4(projection), glm::dvec4(0, 0, 300, 200));
        EXPECT_NEAR(window.x, pixel.x + 0.5, 1e-6);
        EXPECT_NEAR(window.y, 200 - (pixel.y + 0.5), 1e-6);
        EXPECT_GT((glm::dmat4(projection) * glm::dmat4(view) * glm::dvec4(*point, 1)).w, 0);
    }
    EXPECT_GT(found, 1500);
}

TEST(Positioning, rays_along_planes_and_points_behind_have_no_answer)
{
    const glm::mat4 one(1);
    const glm::mat4 projection = glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 9.0F);
    EXPECT_FALSE(point_on_plane({0, 0}, {1, 1}, one, projection, {{1, 0, 0}, 3})) << "along the ray";
    EXPECT_FALSE(point_on_plane({0, 0}, {1, 1}, one, projection, {{1, 0, 0}, 0})) << "through the observer";
    EXPECT_FALSE(point_on_plane({0, 0}, {1, 1}, one, projection, {{0, 0, 1}, 2})) << "behind";
    const auto beyond = point_on_plane({0, 0}, {1, 1}, one, projection, {{0, 0, 1}, -50});
    ASSERT_TRUE(beyond) << "the far plane cuts nothing off";
    EXPECT_NEAR(glm::length(*beyond - glm::dvec3(0, 0, -50)), 0, 1e-12);
}

}
}
