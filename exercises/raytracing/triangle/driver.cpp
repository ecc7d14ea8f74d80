#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "exact_shots.hpp"
#include "planet.hpp"

namespace umbral {
namespace {

using namespace raytracing;

// All questions of a case lie at one place in memory, so that who keeps something for the next call, and knows the
// triangle by its address, keeps what belongs to another.
template <class Each>
void ask_all(Recorder& out, const std::vector<TriangleShot>& shots, const Each& each)
{
    TriangleShot shot;
    for (const TriangleShot& next : shots) {
        shot = next;
        each(ask<intersect_triangle>(out, shot.ray, shot.triangle));
    }
}

void record(Recorder& out, const std::vector<TriangleShot>& shots)
{
    ask_all(out, shots, [&](const auto& hit) { out.append("t", hit ? std::optional(hit->t) : std::nullopt); });
}

void record_all(Recorder& out, const std::vector<TriangleShot>& shots)
{
    ask_all(out, shots, [&](const auto& hit) {
        out.append("t", hit ? std::optional(hit->t) : std::nullopt);
        out.append("a", hit ? std::optional(hit->a) : std::nullopt);
        out.append("b", hit ? std::optional(hit->b) : std::nullopt);
    });
}

// Answers that a student can check by hand, the course's first; each has a twin that passes beside the triangle.
std::vector<TriangleShot> by_hand(Variation& vary)
{
    std::vector<TriangleShot> shots;
    const auto add = [&](glm::vec3 origin, glm::vec3 direction, Triangle triangle, glm::vec3 aside) {
        // Another size, and another corner is the first one.
        const float size = other_size(vary);
        for (int turns = vary.one_of(0, std::array{1, 2}); turns > 0; --turns)
            triangle = {triangle.v1, triangle.v2, triangle.v0};
        triangle = {size * triangle.v0, size * triangle.v1, size * triangle.v2};
        shots.push_back({sized(Ray{origin, direction}, size), triangle});
        shots.push_back({sized(Ray{origin + aside, direction}, size), triangle});
    };
    const Triangle unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    add({0.25F, 0.25F, 5}, {0, 0, -1}, unit, {0.35F, 0.35F, 0});
    add({0.5F, 0.125F, 5}, {0, 0, -2}, unit, {-0.75F, 0, 0});
    add({0.25F, 0.5F, -3}, {0, 0, 1}, unit, {0, -0.75F, 0});
    add({0.125F, 0.75F, 2}, {0, 0, -0.5F}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {0.25F, 0.125F, 0});
    add({3, 1, 2}, {-1, 0, 0}, {{1, 0, 0}, {1, 4, 0}, {1, 0, 8}}, {0, 2, 4});
    add({1, 9, 2}, {0, -1, 0}, {{0, 1, 0}, {4, 1, 0}, {0, 1, 4}}, {2, 0, 0.5F});
    add({0, 0, 4}, {1, 0, -2}, {{1, -1, 0}, {3, -1, 0}, {1, 3, 0}}, {0, 2, 0});
    add({1, 1, 10}, {0, 0, -1}, {{0, 0, 0}, {4, 0, 2}, {0, 4, 0}}, {-2, 0, 0});
    add({-2, 1, 3}, {1, 0, -1}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {4, 2, 0});
    add({0, 0, 0}, {1, 1, 1}, {{3, 0, 0}, {0, 3, 0}, {0, 0, 6}}, {4, 0, 0});
    return in_pairs(vary, std::move(shots));
}

// Edges and corners belong to the triangle; the twin passes beside it, by a quarter of a side or by 4e-6 to 2e-5 of it.
std::vector<TriangleShot> at_the_edges(Random& random)
{
    const glm::vec2 on[] = {{0, 2}, {1, 0}, {1, 3}, {0, 0}, {4, 0}, {0, 4}, {3, 1}, {0, 1}, {2, 0}};
    const glm::vec2 beside[] = {{-1, 2}, {1, -1}, {2, 3}, {-1, -1}, {5, 0}, {0, 5}, {3, 2}, {-1, 1}, {2, -1}};
    std::vector<TriangleShot> shots;
    for (int i = 0; i < 90; ++i) {
        const TriangleShot hit = exact_shot(random, on[i % 9], 3);
        const float by = i % 2 == 0 ? 1.0F : std::ldexp(1.0F, -14 - static_cast<int>(random.below(3)));
        add_pair(shots, hit, exact_shot(random, on[i % 9] + by * (beside[i % 9] - on[i % 9]), 3), random);
    }
    add_odd_parts(shots, random);
    return shots;
}

// Where the interval (t_min, t_max) decides: the triangle lies behind, before t_min, or beyond t_max. A point at an end
// of it does not count; where it begins behind the origin, points there do. It may lie behind the origin as a whole,
// have no end, or be empty. Half of the directions are of any length.
std::vector<TriangleShot> intervals(Random& random)
{
    std::vector<TriangleShot> shots;
    for (int i = 0; i < 240; ++i) {
        const TriangleShot ahead = exact_shot(random, {1, 1 + i % 2}, 3);
        const TriangleShot behind = exact_shot(random, {1, 1 + i % 2}, -3);
        // Every second time at a corner: there the ray begins where the triangle does.
        const TriangleShot there = exact_shot(random, i % 24 == 7 ? glm::vec2(0) : glm::vec2(1, 2), 0);
        const float length = i / 12 % 2 == 0 ? 1 : std::ldexp(1.0F, static_cast<int>(random.below(81)) - 40);
        const auto in = [&](TriangleShot shot, float t_min, float t_max) {
            shot.ray.t_min = t_min;
            shot.ray.t_max = t_max;
            shot.ray = counted_in(shot.ray, length);
            return shot;
        };
        switch (i % 12) {
            case 0: add_pair(shots, in(ahead, 0, endless), in(behind, 0, endless), random); break;
            case 1: add_pair(shots, in(ahead, 2.75F, endless), in(ahead, 3.25F, endless), random); break;
            case 2: add_pair(shots, in(ahead, 0, 3.25F), in(ahead, 0, 2.75F), random); break;
            case 3: add_pair(shots, in(ahead, 3 * barely_less, endless), in(ahead, 3, endless), random); break;
            case 4: add_pair(shots, in(ahead, 0, 3 * barely_more), in(ahead, 0, 3), random); break;
            case 5: add_pair(shots, in(behind, -3 * barely_more, -2), in(behind, -3, -2), random); break;
            case 6: add_pair(shots, in(ahead, -4, endless), in(behind, -2, endless), random); break;
            case 7: add_pair(shots, in(there, -1, 1), in(there, 0, endless), random); break;
            case 8: add_pair(shots, in(behind, -endless, endless), in(behind, 0, endless), random); break;
            case 9: add_pair(shots, in(ahead, -endless, 3.25F), in(ahead, -endless, 2.75F), random); break;
            case 10: add_pair(shots, in(behind, -endless, -2.75F), in(behind, -endless, -3.25F), random); break;
            default: add_pair(shots, in(ahead, 2.75F, 3.25F), in(ahead, 3.25F, 2.75F), random);
        }
    }
    return shots;
}

// Rays parallel to the triangle and in its plane, triangles without area, rays without a direction and with NaN in
// them.
std::vector<TriangleShot> nothing_to_hit(Random& random)
{
    std::vector<TriangleShot> shots;
    for (int i = 0; i < 90; ++i) {
        const TriangleShot hit = exact_shot(random, {1, 1}, 3);
        TriangleShot none = hit;
        const glm::vec3 edge = hit.triangle.v1 - hit.triangle.v0;
        const auto axis = random.below(3);
        switch (i % 9) {
            case 0: none.ray.direction = edge; break;
            case 1: none.ray = {hit.triangle.v0 + 0.25F * (hit.triangle.v2 - hit.triangle.v0) - edge, edge}; break;
            case 2: none.triangle.v2 = hit.triangle.v0 + 2.0F * edge; break;
            case 3: none.triangle.v2 = none.triangle.v1; break;
            case 4: none.ray.direction = glm::vec3(0); break;
            case 5: none.ray.direction[axis] = not_a_number; break;
            case 6: none.ray.t_min = not_a_number; break;
            case 7: none.ray.t_max = not_a_number; break;
            default: none.ray.origin[axis] = not_a_number;
        }
        add_pair(shots, hit, none, random);
    }
    return shots;
}

// The same lines with directions of all lengths, some of whose squares no float holds, and the same figures in all
// sizes.
std::vector<TriangleShot> sizes(Random& random)
{
    std::vector<TriangleShot> shots = random_pairs(random, 300, 0.2, 1, 0.01);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        auto& [ray, triangle] = shots[i];
        const std::size_t kind = i / 2 % 3;
        if (kind < 2) {
            const float power = random.uniform(-6, 6);
            ray.direction *=
                std::pow(10.0F, kind == 0 && i % 4 < 2 ? std::copysign(22 + std::abs(power), power) : power);
        }
        if (kind == 0) continue;
        const float scale = std::exp2(std::floor(i % 4 < 2 ? random.uniform(-30, -12) : random.uniform(12, 30)));
        ray.origin *= scale;
        for (glm::vec3* corner : {&triangle.v0, &triangle.v1, &triangle.v2}) *corner *= scale;
    }
    return shots;
}

// Rays nearly in the plane, close to an edge, and at slivers: double is good enough for them. Of the first ones every
// second pair is tiny, and every fourth huge, in figure and direction: no float holds their determinants.
std::vector<TriangleShot> for_double(Random& random)
{
    std::vector<TriangleShot> shots = random_pairs(random, 300, 1e-4, 1e-2, 0.1);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        auto& [ray, triangle] = shots[i];
        const std::size_t pair = i / 2;
        if (pair % 4 == 0) continue;
        const float sign = pair % 4 == 3 ? 1 : -1;
        const float size = std::exp2(sign * std::floor(random.uniform(16, 31)));
        ray.direction *= std::exp2(sign * std::floor(random.uniform(75, 91)));
        ray.origin *= size;
        for (glm::vec3* corner : {&triangle.v0, &triangle.v1, &triangle.v2}) *corner *= size;
    }
    add_close_to_edges(shots, 70, random);
    add_slivers(shots, 70, random);
    add_needles(shots, 110, random);
    return shots;
}

/// Where a ray first meets one of these.
std::optional<float> first_distance(Recorder& out, Ray ray, std::span<const Triangle> triangles)
{
    std::optional<float> t;
    for (const Triangle& triangle : triangles) {
        const std::optional<TriangleHit> hit = ask<intersect_triangle>(out, ray, triangle);
        if (hit && hit->t < ray.t_max) ray.t_max = *(t = hit->t);
    }
    return t;
}

/// Each coordinate is one of the 2 `reach` + 1 whole numbers nearest to 0.
glm::vec3 whole_numbers(Random& random, int reach)
{
    const auto one = [&] {
        return static_cast<float>(random.below(static_cast<unsigned>(2 * reach + 1))) - static_cast<float>(reach);
    };
    const float x = one();
    const float y = one();
    return {x, y, one()};
}

// Two triangles on both sides of an edge, and a ray that crosses the edge, all at whole numbers: the crossing is exact,
// and where formulas divide by the direction, what they round must not let the ray pass between the two.
void record_seams(Random& random, Recorder& out)
{
    for (int i = 0; i < 250; ++i) {
        glm::vec3 step;
        glm::vec3 direction;
        do {
            step = whole_numbers(random, 6);
            direction = whole_numbers(random, 15);
        } while (cross(step, direction) == glm::vec3(0));
        const auto [before, behind] =
            std::pair(1.0F + static_cast<float>(random.below(3)), 1.0F + static_cast<float>(random.below(3)));
        const glm::vec3 crossing = whole_numbers(random, 20);
        const glm::vec3 from = crossing - before * step;
        const glm::vec3 to = crossing + behind * step;
        const glm::vec3 across = cross(step, direction);
        glm::vec3 aside;
        do aside = whole_numbers(random, 12);
        while (dot(aside, across) == 0);
        const std::array triangles = {Triangle{from, to, crossing + aside},
                                      Triangle{to, from, crossing - aside + step}};
        const Ray ray{crossing - (1.0F + static_cast<float>(random.below(4))) * direction, direction};
        const Ray turned_away{ray.origin, -direction};
        const bool first = random.below(2) == 0;
        for (const bool hits : {first, !first})
            out.append("t", first_distance(out, hits ? ray : turned_away, triangles));
    }
}

// Rays from inside a closed mesh, at its corners and its edges' points; every second one begins outside and leaves.
// What is recorded is the first triangle's distance.
void record_mesh(Random& random, Recorder& out)
{
    const std::vector<Triangle> mesh = bumpy_ball();
    for (int i = 0; i < 240; ++i) {
        const Triangle& triangle = mesh[random.below(static_cast<std::uint32_t>(mesh.size()))];
        const double along = i % 3 == 0 ? 0 : random.uniform_double();
        const glm::dvec3 target = glm::mix(glm::dvec3(triangle.v0), glm::dvec3(triangle.v1), along);
        const glm::vec3 origin = 0.4F * random.in_cube();
        const Ray inside{origin, glm::vec3(normalize(target - glm::dvec3(origin)))};
        const Ray leaves{glm::vec3(3.0 * normalize(target)), inside.direction};
        const bool first = random.below(2) == 0;
        for (const bool hits : {first, !first}) {
            const Ray ray = hits ? inside : leaves;
            // The driver's own test of a ball round each triangle spares most questions.
            std::vector<Triangle> near;
            std::ranges::copy_if(mesh, std::back_inserter(near), [&](const Triangle& other) {
                const glm::vec3 centre = (other.v0 + other.v1 + other.v2) / 3.0F;
                return length(cross(centre - ray.origin, ray.direction)) <= 0.35F;
            });
            out.append("t", first_distance(out, ray, near));
        }
    }
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int size = 240;
    const Camera camera = varied(vary, planet_camera);
    const std::vector<Triangle> triangles = bumpy_ball();
    const auto asked = [&](const Ray& ray, const Triangle& t) { return ask<intersect_triangle>(out, ray, t); };
    Grid<std::uint32_t> ids(size / 2, size / 2);
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            ids.at(x, y) =
                nearest(asked, camera_ray(camera, ids.width, ids.height, glm::vec2(x, y) + 0.5F), triangles).id;
    out.buffer("ids", ids);
    out.image("planet", ray_traced(size, size, camera, [&](const Ray& ray) { return planet_light(ray, triangles); }));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_all(out, by_hand(c.vary)); }},
    {"random", [](Case& c, Recorder& out) { record_all(out, random_pairs(c.random, 800, 0.2, 1, 0.01)); }},
    {"edges", [](Case& c, Recorder& out) { record(out, at_the_edges(c.random)); }},
    {"intervals", [](Case& c, Recorder& out) { record(out, intervals(c.random)); }},
    {"nothing", [](Case& c, Recorder& out) { record(out, nothing_to_hit(c.random)); }},
    {"sizes", [](Case& c, Recorder& out) { record(out, sizes(c.random)); }},
    {"seams", [](Case& c, Recorder& out) { record_seams(c.random, out); }},
    {"mesh", [](Case& c, Recorder& out) { record_mesh(c.random, out); }},
    {"grazing", [](Case& c, Recorder& out) { record_all(out, for_double(c.random)); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
