#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "castle.hpp"
#include "exact.hpp"
#include "shots.hpp"

namespace umbral {
namespace {

using namespace raytracing;

using MakeRays = std::vector<Ray> (*)(Quadric, Random&);

void record_cylinder(Recorder& out, const std::vector<Ray>& rays)
{
    for (const Ray& ray : rays) out.append("cylinder", ask<intersect_unit_cylinder>(out, ray));
}

void record_cone(Recorder& out, const std::vector<Ray>& rays)
{
    for (const Ray& ray : rays) out.append("cone", ask<intersect_unit_cone>(out, ray));
}

void record_both(Random& random, Recorder& out, MakeRays rays)
{
    record_cylinder(out, rays(Quadric::cylinder, random));
    record_cone(out, rays(Quadric::cone, random));
}

// Places on both surfaces, within, without, above and below. Of those far away the values are divided by what their
// squares have as a factor, a power of two: they are as exact as the others.
void record_fields(Random& random, Recorder& out)
{
    std::vector<glm::vec3> places = {{1, 0.5F, 0},       {0, 0, -1},        {0, 1, 0},     {0.5F, 0.5F, 0},
                                     {0, 3, 2},          {0, 0.5F, 3},      {2, 0.25F, 1}, {0, 0, 0},
                                     {0.25F, -1, -1.5F}, {-0.75F, 2, 0.5F}, {0, -2, 3},    {0.5F, 0.75F, 0.25F}};
    for (int i = 0; i < 60; ++i) places.push_back(3.0F * random.in_cube());
    const auto record_at = [&](const glm::vec3& place, float factor) {
        out.append("cylinder", ask<unit_cylinder_field>(out, place) / factor);
        out.append("cone", ask<unit_cone_field>(out, place) / factor);
    };
    for (const glm::vec3& place : places) record_at(place, 1);
    for (int i = 0; i < 12; ++i)
        for (const glm::vec3& place : numbers_changed(random, 3.0F * random.in_cube(), 3)) record_at(place, 1);
    for (int i = 0; i < 30; ++i) {
        const float size = std::ldexp(1.0F, 1 + static_cast<int>(random.below(20)));
        record_at(3.0F * size * random.in_cube(), size * size);
    }
}

// Where the interval (t_min, t_max) decides. Of the first three kinds both points are taken out of one of the rays, of
// the fourth only the first: the other counts. Of the last both lie behind the origin, within the interval of one.
std::vector<Ray> behind_and_before(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 200; ++i) {
        const Chord both = chord(quadric, height_on(quadric, random), height_on(quadric, random), random);
        const Ray hit = along(both, -0.5 - random.uniform_double());
        const float entry = distance(hit.origin, glm::vec3(both.entry));
        const float exit = distance(hit.origin, glm::vec3(both.exit));
        Ray kept = hit;
        Ray miss = hit;
        switch (i % 5) {
            case 0: miss.direction = -miss.direction; break;
            case 1: miss.t_min = 1.01F * exit; break;
            case 2:
                miss.t_max = 0.99F * entry;
                kept.t_max = 1.01F * entry;
                break;
            case 3:
                kept.direction = -kept.direction;
                kept.t_min = miss.t_min = -endless;
                kept.t_max = miss.t_max = 0;
                break;
            default:
                kept.t_min = 0.5F * (entry + exit);
                miss.t_min = kept.t_min;
                miss.t_max = 0.99F * exit;
        }
        add_pair(rays, kept, miss, random);
    }
    return rays;
}

// Rays that begin on the surface, rounded, with an interval that leaves that point out: those inwards may meet it
// again.
std::vector<Ray> from_the_surface(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 80; ++i) {
        const double on = 0.3 + 0.4 * random.uniform_double();
        const Chord hit = chord(quadric, on, 0.3 + 0.4 * random.uniform_double(), random);
        const Chord miss = i % 2 == 0 ? chord(quadric, on, height_off(quadric, random), random) : hit;
        Ray again = along(hit, 0);
        Ray away = along(miss, 0);
        if (i % 2 == 1) away.direction = -away.direction;
        again.t_min = away.t_min = 1e-3F;
        add_pair(rays, again, away, random);
    }
    return rays;
}

// Level rays, of which two of three run along an axis. The twin passes above, below or beside; above the apex it would
// meet the cone, were it endless.
std::vector<Ray> level(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 60; ++i) {
        const float angle = random.uniform(0, 6.2831853F);
        glm::vec3 way(std::cos(angle), 0, std::sin(angle));
        if (i % 3 > 0) way = i % 3 == 1 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
        if (random.below(2) == 0) way = -way;
        const glm::vec3 side(-way.z, 0, way.x);
        // How far from the axis it passes is told in radii.
        const auto at = [&](float height, float aside) {
            const float radius = quadric == Quadric::cylinder ? 1 : std::abs(1 - height);
            const glm::vec3 nearest = glm::vec3(0, height, 0) + aside * radius * side;
            return Ray{nearest - random.uniform(1.5F, 4) * way, way};
        };
        const float aside = random.uniform(-0.9F, 0.9F);
        const Ray hit = at(random.uniform(0.1F, 0.8F), aside);
        Ray miss = at(random.uniform(0.1F, 0.8F), aside < 0 ? aside - 1.1F : aside + 1.1F);
        if (i % 4 == 0) miss = at(random.uniform(1.1F, 2), aside);
        if (i % 4 == 1) miss = at(random.uniform(-1, -0.1F), aside);
        add_pair(rays, hit, miss, random);
    }
    return rays;
}

// The same lines with directions of all lengths: t counts in them. A pair has both of one kind, short or long.
std::vector<Ray> lengths(Quadric quadric, Random& random)
{
    std::vector<Ray> rays = random_pairs(quadric, random, 150);
    for (std::size_t i = 0; i < rays.size(); ++i)
        rays[i].direction *= std::pow(10.0F, i / 2 % 2 == 0 ? random.uniform(-6, -3) : random.uniform(3, 6));
    return rays;
}

// Rays without a direction, or with NaN in them; each has a twin without fault.
std::vector<Ray> no_rays(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < 60; ++i) {
        const Ray hit = along(chord(quadric, height_on(quadric, random), height_off(quadric, random), random), -1);
        Ray none = hit;
        const auto axis = random.below(3);
        switch (i % 6) {
            case 0: none.direction = glm::vec3(0); break;
            case 1:
                none.origin = {axis == 0 ? 1 : 0.125F, axis == 1 ? 0.5F : 0, 0};
                none.direction = glm::vec3(0);
                none.t_min = -endless;
                break;
            case 2: none.direction[axis] = not_a_number; break;
            case 3: none.origin[axis] = not_a_number; break;
            case 4: none.t_max = not_a_number; break;
            default: none.t_min = not_a_number;
        }
        add_pair(rays, hit, none, random);
    }
    return rays;
}

std::vector<Ray> from_far_away(Quadric quadric, Random& random)
{
    std::vector<Ray> rays;
    for (const double distance : {1e3, 1e4, 1e5}) {
        const std::vector<Ray> more = far_pairs(quadric, random, distance, 100);
        rays.insert(rays.end(), more.begin(), more.end());
    }
    const std::vector<Ray> glancing = glancing_pairs(quadric, random, 150);
    rays.insert(rays.end(), glancing.begin(), glancing.end());
    return rays;
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int width = 288;
    constexpr int height = 216;
    const Camera camera = varied(vary, {{0.9F, 1.25F, 8.6F}, {0, 1.5F, 0}, 0.35F});
    const std::vector<Piece> pieces = castle();
    const auto cylinder = [&](const Ray& ray) { return ask<intersect_unit_cylinder>(out, ray); };
    const auto cone = [&](const Ray& ray) { return ask<intersect_unit_cone>(out, ray); };
    Grid<std::uint32_t> ids(width / 2, height / 2);
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x) {
            const Ray ray = camera_ray(camera, ids.width, ids.height, glm::vec2(x, y) + 0.5F);
            ids.at(x, y) = nearest_piece(cylinder, cone, ray, pieces).id;
        }
    out.buffer("ids", ids);
    out.image("castle", ray_traced(width, height, camera, [&](const Ray& ray) { return castle_light(ray, pieces); }));
}

}

const Driver driver = {
    {"fields", [](Case& c, Recorder& out) { record_fields(c.random, out); }},
    {"by hand",
     [](Case&, Recorder& out) {
         record_cylinder(out, cylinder_by_hand());
         record_cone(out, cone_by_hand());
     }},
    {"random",
     [](Case& c, Recorder& out) {
         record_both(c.random, out, [](Quadric q, Random& random) { return random_pairs(q, random, 600); });
         record_both(c.random, out, level);
     }},
    {"open ends",
     [](Case& c, Recorder& out) {
         record_both(c.random, out, [](Quadric q, Random& random) { return open_pairs(q, random, 200); });
     }},
    {"parallel", [](Case& c, Recorder& out) { record_both(c.random, out, parallel); }},
    {"rims", [](Case& c, Recorder& out) { record_both(c.random, out, at_the_rims); }},
    {"behind and before", [](Case& c, Recorder& out) { record_both(c.random, out, behind_and_before); }},
    {"ends", [](Case& c, Recorder& out) { record_both(c.random, out, at_the_ends); }},
    {"from the surface", [](Case& c, Recorder& out) { record_both(c.random, out, from_the_surface); }},
    {"lengths", [](Case& c, Recorder& out) { record_both(c.random, out, lengths); }},
    {"no ray", [](Case& c, Recorder& out) { record_both(c.random, out, no_rays); }},
    {"far away", [](Case& c, Recorder& out) { record_both(c.random, out, from_far_away); }},
    {"nearly parallel",
     [](Case& c, Recorder& out) {
         record_both(c.random, out, [](Quadric q, Random& random) { return nearly_parallel_pairs(q, random, 150); });
     }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
