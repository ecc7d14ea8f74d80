#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <raytracing/shadow-polygons/polygons.hpp>

// Shadows against single rays to the light, and mirrors against paths of light: no polygon is cut here.
namespace umbral::raytracing {
namespace {

constexpr std::uint64_t seed = 20260112;

glm::dvec3 area_of(const FlatPolygon& polygon)
{
    glm::dvec3 area(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area +=
            cross(glm::dvec3(polygon[i - 1]) - glm::dvec3(polygon[0]), glm::dvec3(polygon[i]) - glm::dvec3(polygon[0]));
    return area;
}

// How far inside a convex polygon a point of its plane lies; negative outside.
double depth_in(const FlatPolygon& polygon, const glm::dvec3& p)
{
    const glm::dvec3 normal = normalize(area_of(polygon));
    double least = 1e30;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a(polygon[i]);
        const glm::dvec3 side = glm::dvec3(polygon[(i + 1) % polygon.size()]) - a;
        least = std::min(least, dot(cross(side, p - a), normal) / length(side));
    }
    return least;
}

// Where the segment (or, to a sun, the ray) from p to the light meets the polygon's plane; how far inside it that is.
double blocked(const glm::dvec3& p, const glm::vec4& light, const FlatPolygon& caster)
{
    const glm::dvec3 direction = glm::dvec3(light) - double{light.w} * p;
    const glm::dvec3 normal = area_of(caster);
    const double t = dot(normal, glm::dvec3(caster[0]) - p) / dot(normal, direction);
    if (!(t > 0) || (light.w != 0 && t >= 1)) return -1e30;
    return depth_in(caster, p + t * direction);
}

TEST(ShadowPolygons, a_point_is_in_the_shadow_exactly_if_a_ray_to_the_light_meets_the_caster)
{
    Random random(seed);
    int in_shadow = 0;
    for (int i = 0; i < 600; ++i) {
        const ShadowTask task = random_shadow(random, i);
        const FlatPolygon shadow = shadow_polygon(task.light, task.caster, task.receiver);
        for (int k = 0; k < 40; ++k) {
            glm::dvec3 p(0);
            double sum = 0;
            for (const glm::vec3& corner : task.receiver) {
                const double weight = random.uniform_double();
                p += weight * glm::dvec3(corner);
                sum += weight;
            }
            p /= sum;
            const double expected = blocked(p, task.light, task.caster);
            const double found = shadow.empty() ? -1e30 : depth_in(shadow, p);
            if (std::abs(expected) < 1e-4 || std::abs(found) < 1e-4) continue;
            EXPECT_EQ(expected > 0, found > 0) << "seed " << seed << ", task " << i;
            in_shadow += expected > 0 ? 1 : 0;
        }
        EXPECT_TRUE(shadow.empty() || dot(area_of(shadow), area_of(task.receiver)) > 0);
    }
    EXPECT_GT(in_shadow, 3000);
}

TEST(ShadowPolygons, a_mirror_matrix_is_its_own_inverse_and_keeps_its_plane)
{
    Random random(seed + 1);
    for (int i = 0; i < 500; ++i) {
        const glm::vec4 plane = random_plane(random, i);
        const glm::mat4 mirror = mirror_matrix(plane);
        const glm::vec3 p = 3.0F * random.in_cube();
        const glm::vec3 image(mirror * glm::vec4(p, 1));
        EXPECT_LT(distance(glm::vec3(mirror * glm::vec4(image, 1)), p), 1e-5F) << "seed " << seed;
        const glm::dvec3 middle = 0.5 * (glm::dvec3(p) + glm::dvec3(image));
        EXPECT_NEAR(dot(glm::dvec4(plane), glm::dvec4(middle, 1)) / length(glm::dvec3(plane)), 0, 1e-5);
        EXPECT_NEAR(determinant(glm::mat3(mirror)), -1, 1e-5F);
    }
}

// Light from a point that a way shows: from the last mirrored eye through the window to the point; folded back mirror
// by mirror it must meet each mirror of the path, and reach the eye in a path of the same length.
TEST(ShadowPolygons, each_way_is_a_path_of_light_that_meets_its_mirrors_in_their_order)
{
    Random random(seed + 2);
    int longest = 0;
    for (int i = 0; i < 200; ++i) {
        const MirrorTask task = random_mirrors(random, 2 + random.below(3), 4);
        for (const MirrorView& view : mirror_views(task.eye, task.mirrors, task.levels)) {
            ASSERT_GE(view.window.size(), 3U);
            glm::dvec3 middle(0);
            for (const glm::vec3& corner : view.window) middle += glm::dvec3(corner) / double(view.window.size());
            glm::dvec3 eye(view.eye);
            glm::dvec3 from = middle + 0.1 * (middle - eye);
            const double whole = distance(eye, from);
            double travelled = 0;
            for (std::size_t k = view.path.size(); k-- > 0;) {
                const FlatPolygon& mirror = task.mirrors[view.path[k]];
                const glm::dvec3 normal = normalize(area_of(mirror));
                const double h_from = dot(normal, from - glm::dvec3(mirror[0]));
                const double h_eye = dot(normal, eye - glm::dvec3(mirror[0]));
                ASSERT_GT(h_from, -1e-5) << "seed " << seed << ", task " << i;
                ASSERT_LT(h_eye, 0);
                const glm::dvec3 met = from + h_from / (h_from - h_eye) * (eye - from);
                EXPECT_GT(depth_in(mirror, met), -1e-4) << "seed " << seed << ", task " << i;
                travelled += distance(from, met);
                from = met;
                eye -= 2 * h_eye * normal;
            }
            travelled += distance(from, eye);
            EXPECT_LT(distance(eye, glm::dvec3(task.eye)), 1e-4);
            EXPECT_NEAR(travelled, whole, 1e-4);
            longest = std::max(longest, static_cast<int>(view.path.size()));
        }
    }
    EXPECT_EQ(longest, 4);
}

TEST(ShadowPolygons, two_parallel_mirrors_have_images_at_multiples_of_their_distance)
{
    const FlatPolygon left = rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 3});
    const FlatPolygon right = rectangle({4, 0, -1}, {0, 0, 5}, {0, 2, 0});
    const std::vector<MirrorView> views = mirror_views({1, 1, 1}, {left, right}, 2);
    ASSERT_EQ(views.size(), 4U);
    const float expected[] = {-1, 9, 7, -7};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(views[i].eye, glm::vec3(expected[i], 1, 1)) << i;
    EXPECT_EQ(views[1].path, (std::vector<std::size_t>{0, 1}));
}

}
}
