#include <kit/amount.hpp>
#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/not_finite.hpp>

#include "box_shots.hpp"
#include "knot.hpp"
#include "many_tiles.hpp"
#include "soups.hpp"

namespace umbral {
namespace {

using namespace raytracing;
using Hierarchy = std::unique_ptr<TriangleHierarchy>;

Hierarchy hierarchy_of(Recorder& out, const Soup& soup, std::string_view name = "hierarchy")
{
    return ask_new<make_triangle_hierarchy>(out, name, std::span<const Triangle>(soup));
}

void record_answer(Recorder& out, const Hierarchy& hierarchy, const Ray& ray)
{
    std::optional<FirstTriangle> first;
    if (hierarchy) first = ask<&TriangleHierarchy::first_hit>(out, *hierarchy, ray);
    out.append("t", first ? std::optional(first->hit.t) : std::nullopt);
    out.append("index", first ? std::optional(static_cast<float>(first->index)) : std::nullopt);
}

void record(Recorder& out, const Soup& soup, int rays, float distance, Random& random)
{
    const Hierarchy hierarchy = hierarchy_of(out, soup);
    for (int i = 0; i < rays; ++i) record_answer(out, hierarchy, ray_into(soup, distance, random));
}

void record_boxes(Recorder& out, Random& random)
{
    const auto ask_for = [&](const Soup& soup) {
        const BoundingBox box = ask<bounding_box>(out, std::span<const Triangle>(soup));
        out.append("low", recordable(box.low));
        out.append("high", recordable(box.high));
    };
    ask_for({{{1, 2, 3}, {4, 0, 6}, {-7, 8, 9}}});
    ask_for({{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {{-1, 5, 2}, {0, 0, 0}, {2, 2, 7}}});
    ask_for({{{-3, -2, -5}, {-4, -6, -1}, {-2, -9, -8}}});
    ask_for({});
    ask_for({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}});
    for (int i = 0; i < 30; ++i) ask_for(random_soup(random, 1 + static_cast<int>(random.below(9)), 1));
    for (int i = 0; i < 10; ++i) {
        Soup soup = random_soup(random, 3, 1);
        for (Triangle& triangle : soup)
            for (glm::vec3* corner : {&triangle.v0, &triangle.v1, &triangle.v2})
                *corner = (i % 2 == 0 ? 1e6F : -1e30F) * (*corner + glm::vec3(i < 5 ? 9 : -9));
        ask_for(soup);
    }
}

void record(Recorder& out, const std::vector<BoxShot>& shots)
{
    for (const auto& [ray, box] : shots) out.append("meets", ask<meets_box>(out, ray, box));
}

std::vector<BoxShot> random_boxes(Random& random)
{
    std::vector<BoxShot> shots;
    for (int i = 0; i < 400; ++i) add_box_pair(shots, i, random);
    return shots;
}

void few(Recorder& out, Random& random)
{
    for (int count = 0; count <= 9; ++count) record(out, random_soup(random, count, 2), count == 0 ? 2 : 20, 9, random);
}

// The same soup in several sizes, with directions of all lengths: a distance that is small in one is large in another.
void random_rays(Recorder& out, Random& random)
{
    for (int i = 0; i < 5; ++i) {
        const float size = any_size(random);
        const Soup soup = random_soup(random, 250, 0.8F);
        const Hierarchy hierarchy = hierarchy_of(out, sized(soup, size));
        for (int k = 0; k < 60; ++k) {
            Ray ray = ray_into(soup, 9, random);
            ray.origin *= size;
            ray.direction *= size * std::exp2(std::floor(random.uniform(-8, 8)));
            record_answer(out, hierarchy, ray);
        }
        // In the planes of two axes, and along one.
        for (int k = 0; k < 18; ++k) {
            Ray ray = ray_into(soup, 9, random);
            for (int axis = k % 3; axis < k % 3 + (k < 9 ? 1 : 2); ++axis) {
                ray.origin[axis % 3] += 9 * ray.direction[axis % 3];
                ray.direction[axis % 3] = 0;
            }
            record_answer(out, hierarchy, sized(ray, size));
        }
    }
}

// Directions of all lengths, intervals that begin behind the origin, beyond the first hits or end before the last, and
// origins inside. The same ray is asked again with other ends.
void intervals(Recorder& out, Random& random)
{
    const Soup soup = random_soup(random, 200, 0.75F);
    const Hierarchy hierarchy = hierarchy_of(out, soup);
    for (int i = 0; i < 200; ++i) {
        Ray ray = ray_into(soup, random.uniform(0, 8), random);
        if (i % 2 == 0) ray.t_min = random.uniform(-6, 9);
        if (i % 8 == 0) {
            // The soup, or most of it, lies behind the origin.
            ray.origin += 9.0F * ray.direction;
            ray.t_min = random.uniform(-14, -4);
        }
        if (i % 3 == 0) ray.t_max = random.uniform(2, 9);
        const float longer = std::exp2(std::floor(i % 3 == 0 ? random.uniform(-110, 110) : random.uniform(-9, 9)));
        record_answer(out, hierarchy, {ray.origin, longer * ray.direction, ray.t_min / longer, ray.t_max / longer});
        if (i % 5 != 0) continue;
        ray.t_max = random.uniform(1, 9);
        record_answer(out, hierarchy, {ray.origin, longer * ray.direction, ray.t_min / longer, ray.t_max / longer});
        const auto is_ray = [](const Ray& one) { return one.direction != glm::vec3(0) && one.t_min < one.t_max; };
        for (const Ray& changed : numbers_changed(random, ray, 3, is_ray)) record_answer(out, hierarchy, changed);
    }
}

// Two hierarchies, asked by turns; the lists that they were made from are written over meanwhile.
void two_by_turns(Recorder& out, Random& random)
{
    const Soup soups[] = {random_soup(random, 60, 1.5F), random_soup(random, 90, 1.5F)};
    Soup list = soups[0];
    const Hierarchy first = hierarchy_of(out, list, "first");
    list = soups[1];
    const Hierarchy second = hierarchy_of(out, list, "second");
    for (Triangle& triangle : list) triangle = {};
    for (int i = 0; i < 100; ++i)
        for (const int which : {0, 1})
            record_answer(out, which == 0 ? first : second, ray_into(soups[i % 2], 9, random));
}

void odd_triangles(Recorder& out, Random& random)
{
    record(out, shells(300, random), 60, 500, random);
    record(out, Soup(100, random_soup(random, 1, 3).front()), 10, 9, random);
    record(out, row_of_powers(60, random), 60, 9, random);
    record(out, needles(2000, random), 60, 9, random);
    record(out, with_points_and_twins(random, 120), 60, 9, random);
    record(out, floor_of_tiles(16), 60, 20, random);
}

// Of several triangles at one distance the one of the least index counts: twins, and tiles that share an edge or a
// corner. Places are exact, and so is t in one of four: elsewhere a tile begins beyond its own t, which was rounded.
void ties(Recorder& out, Random& random)
{
    Soup tiles = floor_of_tiles(8);
    tiles.insert(tiles.end(), tiles.begin(), tiles.end());
    tiles = in_random_order(random, std::move(tiles));
    const Hierarchy hierarchy = hierarchy_of(out, tiles);
    for (int i = 0; i < 200; ++i) {
        const glm::vec2 place(static_cast<float>(random.below(16)) / 2, static_cast<float>(random.below(16)) / 2);
        const float side = random.below(2) == 0 ? 1 : -1;
        const float length = random.uniform(0.25F, 3) * std::exp2(std::floor(random.uniform(-16, 6)));
        record_answer(out, hierarchy, {{place, 3 * side}, {0, 0, i % 4 == 0 ? -side : -side * length}});
    }
}

// Rays at such legs, of triangles that stand alone and in leaves with a few others: of a box that is missed by a
// rounding, no neighbour finds the same point.
void lone_legs(Recorder& out, Random& random)
{
    const auto ask_at_legs = [&](const Soup& soup, int rays) {
        const Hierarchy hierarchy = hierarchy_of(out, soup);
        for (int i = 0; i < rays; ++i) {
            const Triangle& triangle = soup[random.below(static_cast<std::uint32_t>(soup.size()))];
            const glm::vec3 leg = (random.below(2) == 0 ? triangle.v1 : triangle.v2) - triangle.v0;
            const glm::vec3 target = triangle.v0 + random.uniform(0, 1) * leg;
            const glm::vec3 from = 3.0F * random.in_cube();
            record_answer(out, hierarchy, {from, random.uniform(0.2F, 2) * (target - from)});
        }
    };
    ask_at_legs(legs_on_axes(random, 60), 600);
    for (int i = 0; i < 150; ++i) ask_at_legs(legs_on_axes(random, 1), 6);
}

// Closed bodies from inside and a floor from above, near the origin and far: rays at their corners and edges' middles.
void edges(Recorder& out, Random& random)
{
    for (const float away : {0.0F, 3000.0F}) {
        for (Soup soup : {hilly_ball(6, random), floor_of_tiles(16), triangles_of(shapes::box())}) {
            glm::vec3 inside(0);
            if (soup.size() == 512) inside = {7.3F, 8.1F, 5};
            if (soup.size() == 12) inside = glm::vec3(0.4F, 0.55F, 0.3F);
            const glm::vec3 shift = away * glm::vec3(1, -2, 0.5F);
            for (Triangle& triangle : soup) triangle = {triangle.v0 + shift, triangle.v1 + shift, triangle.v2 + shift};
            const Hierarchy hierarchy = hierarchy_of(out, soup);
            for (int i = 0; i < 150; ++i) {
                const Triangle& triangle = soup[random.below(static_cast<std::uint32_t>(soup.size()))];
                const glm::vec3 target = random.below(2) == 0 ? triangle.v1 : 0.5F * (triangle.v1 + triangle.v2);
                const glm::vec3 from = inside + shift + 0.2F * random.in_cube();
                record_answer(out, hierarchy, {from, target - from});
            }
        }
    }
}

/// Where so many rays hit the soup, of which the hierarchy may have a smaller copy.
Amount amount_of_hits(Recorder& out, const Hierarchy& hierarchy, const Soup& soup, int rays, Random& random,
                      float size = 1)
{
    std::vector<glm::vec3> hits;
    for (int i = 0; hierarchy && i < rays; ++i) {
        Ray ray = ray_into(soup, 4, random);
        ray = {size * ray.origin, size * ray.direction};
        const auto hit = ask<&TriangleHierarchy::first_hit>(out, *hierarchy, ray);
        hits.emplace_back(hit ? hit->hit.t : -1.0F);
    }
    return Amount().in_order(hits);
}

// Bodies as small as dust, where no distance is a small one.
void work(Recorder& out, Random& random)
{
    out.text("of building.names", "triangles");
    out.text("of asking.names", "triangles");
    constexpr float size = 0x1p-40F;
    for (const int n : {6, 10, 16, 24}) {
        const Soup soup = hilly_ball(n, random);
        const Soup dust = sized(soup, size);
        Hierarchy hierarchy;
        // Some rays tell that it is the soup's; they are the same whichever table is worked on.
        Random rays = random;
        record_cost(out, "of building", soup.size(), [&] {
            hierarchy = hierarchy_of(out, dust);
            return amount_of_hits(out, hierarchy, soup, 8, rays, size);
        });
        if (!cost_is_wanted(out, "of asking")) continue;
        if (!hierarchy) hierarchy = hierarchy_of(out, dust);
        record_cost(out, "of asking", soup.size(),
                    [&] { return amount_of_hits(out, hierarchy, soup, 80, random, size); });
    }
}

void odd_work(Recorder& out, Random& random)
{
    out.text("of building.names", "triangles");
    for (const int count : {200, 450, 1000, 2200}) {
        const Soup soup = shells(count, random);
        record_cost(out, "of building", soup.size(), [&] {
            const Hierarchy hierarchy = hierarchy_of(out, soup);
            return amount_of_hits(out, hierarchy, soup, 8, random);
        });
    }
}

void record_picture(Recorder& out)
{
    const KnotScene scene = knot_scene();
    const Hierarchy hierarchy = hierarchy_of(out, scene.triangles);
    if (!hierarchy) return;
    out.image("knot", knot_picture(scene, [&](const Ray& ray) { return hierarchy->first_hit(ray); }));
}

}

const Driver driver = {
    {"boxes", [](Case& c, Recorder& out) { record_boxes(out, c.random); }},
    {"rays and boxes", [](Case& c, Recorder& out) { record(out, random_boxes(c.random)); }},
    {"along the axes", [](Case& c, Recorder& out) { record(out, along_the_axes(c.random)); }},
    {"touching", [](Case& c, Recorder& out) { record(out, touching(c.random)); }},
    {"few", [](Case& c, Recorder& out) { few(out, c.random); }},
    {"random", [](Case& c, Recorder& out) { random_rays(out, c.random); }},
    {"many", [](Case& c, Recorder& out) { many(out, c.random); }},
    {"intervals", [](Case& c, Recorder& out) { intervals(out, c.random); }},
    {"two by turns", [](Case& c, Recorder& out) { two_by_turns(out, c.random); }},
    {"odd triangles", [](Case& c, Recorder& out) { odd_triangles(out, c.random); }},
    {"ties", [](Case& c, Recorder& out) { ties(out, c.random); }},
    {"edges", [](Case& c, Recorder& out) { edges(out, c.random); }},
    {"legs", [](Case& c, Recorder& out) { lone_legs(out, c.random); }},
    {"work", [](Case& c, Recorder& out) { work(out, c.random); }},
    {"odd work", [](Case& c, Recorder& out) { odd_work(out, c.random); }},
    {"picture", [](Case&, Recorder& out) { record_picture(out); }},
};

}
