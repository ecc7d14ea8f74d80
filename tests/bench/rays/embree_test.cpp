#include <gtest/gtest.h>

#include "embree.hpp"
#include "meshes.hpp"

namespace umbral::raytrace::bench {
namespace {

TEST(Embree, sees_the_same_as_the_engine)
{
    const std::vector<Corners> triangles = hilly_sphere(90);
    const Hierarchy hierarchy = make_hierarchy(triangles);
    const EmbreeScene embree(triangles);
    std::vector<Ray> rays = random_rays(20'000);
    for (const Ray& ray : primary_rays(100)) rays.push_back(ray);
    for (const Ray& ray : second_rays(hierarchy, primary_rays(60), false)) rays.push_back(ray);
    int other = 0;
    int hits = 0;
    for (const Ray& ray : rays) {
        const Hit ours = first_hit(hierarchy, ray);
        const Hit theirs = embree.first_hit(ray);
        ASSERT_EQ(is_blocked(hierarchy, ray), ours.triangle != Hit::nothing);
        if ((ours.triangle == Hit::nothing) != (theirs.triangle == Hit::nothing)) {
            ++other;  // along the silhouette one may see what the other does not
            continue;
        }
        if (ours.triangle == Hit::nothing) continue;
        ++hits;
        // Beside an edge the neighbour may be named.
        if (ours.triangle != theirs.triangle) ++other;
        EXPECT_NEAR(ours.t, theirs.t, 2e-4F * theirs.t);
    }
    EXPECT_GT(hits, 10'000);
    EXPECT_LE(other, 20) << "of " << rays.size();
}

TEST(Embree, has_no_more_hits_than_the_engine_where_rays_are_aimed_at_corners)
{
    const std::vector<Corners> triangles = hilly_sphere(50);
    const Hierarchy hierarchy = make_hierarchy(triangles);
    const EmbreeScene embree(triangles);
    int by_embree = 0;
    for (const Corners& one : triangles)
        for (const glm::vec3& corner : {one.a, one.b, one.c, 0.5F * one.a + 0.5F * one.b}) {
            const Ray ray{glm::vec3(0.1F, 0.05F, -0.02F), corner - glm::vec3(0.1F, 0.05F, -0.02F)};
            EXPECT_TRUE(is_blocked(hierarchy, ray));
            by_embree += embree.is_blocked(ray) ? 1 : 0;
        }
    EXPECT_GT(by_embree, static_cast<int>(39 * triangles.size() / 10)) << "it misses some";
}

}
}
