#include <umbral/core/grid.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record(Recorder& out, const std::vector<BallShot>& shots)
{
    for (const auto& [ray, ball] : shots) out.append("t", ask<intersect>(out, ray, ball));
}

// Rays along an axis, with answers that a student can check by hand; each has a twin that passes beside the ball.
std::vector<BallShot> head_on(Variation& vary)
{
    std::vector<BallShot> shots;
    const auto add = [&](glm::vec3 origin, glm::vec3 direction, Sphere ball, glm::vec3 aside) {
        const float size = other_size(vary);
        const Sphere other{size * ball.centre, size * ball.radius};
        shots.push_back({sized(Ray{origin, direction}, size), other});
        shots.push_back({sized(Ray{origin + aside, direction}, size), other});
    };
    add({0, 0, 5}, {0, 0, -1}, {{0, 0, 0}, 1}, {2, 0, 0});
    add({1, 2, 10}, {0, 0, -1}, {{1, 2, 3}, 2}, {0, 3, 0});
    add({-7, 0, 0}, {1, 0, 0}, {{0, 0, 0}, 3}, {0, 0, 4});
    add({2, 9, 2}, {0, -1, 0}, {{2, -1, 2}, 0.5F}, {1, 0, 0});
    add({0, 0, -4}, {0, 0, 1}, {{0, 0, 4}, 2}, {2, 2, 0});
    add({3, 1, 8}, {0, 0, -1}, {{0, 1, 0}, 5}, {4, 0, 0});
    add({8, -3, 4}, {-1, 0, 0}, {{0, 0, 0}, 13}, {8, -12, 8});
    return in_pairs(vary, std::move(shots));
}

// The root behind the origin is no answer: the second one is. Misses begin inside too: the interval ends before the
// surface.
std::vector<BallShot> from_inside(Random& random)
{
    std::vector<BallShot> shots = {{Ray{{0, 0, 0}, {0, 0, -1}}, {{0, 0, 0}, 1}},
                                   {Ray{{0, 0, 0}, {0, 0, -1}, 0, 0.5F}, {{0, 0, 0}, 1}}};
    for (int i = 0; i < 200; ++i) {
        const Sphere ball = random_ball(random);
        const glm::vec3 origin = ball.centre + ball.radius * random.uniform(0, 0.9F) * random.unit_vector();
        const Ray ray{origin, random.unit_vector()};
        Ray short_ray = ray;
        short_ray.t_max = 0.05F * ball.radius;
        add_pair(shots, {ray, ball}, {short_ray, ball}, random);
    }
    return shots;
}

// Where the interval (t_min, t_max) decides: the ball lies behind, before t_min, beyond t_max, or round t_min; or the
// interval ends before it begins, so that it is empty.
std::vector<BallShot> behind_and_before(Random& random)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < 250; ++i) {
        const Sphere ball = random_ball(random);
        const auto distance = random.uniform(2, 6);
        const BallShot hit = aimed(ball, distance, 0.9 * std::sqrt(random.uniform_double()), random);
        const float first = (distance - 1.01F) * ball.radius;
        const float last = (distance + 1.01F) * ball.radius;
        BallShot miss = hit;
        BallShot kept = hit;
        switch (i % 5) {
            case 0: miss.ray.direction = -miss.ray.direction; break;
            case 1: miss.ray.t_min = last; break;
            case 2: miss.ray.t_max = first; break;
            case 3:
                miss.ray.t_min = last;
                miss.ray.t_max = first;
                break;
            default:  // t_min inside the ball: the far root is the first one in the interval
                kept.ray.t_min = distance * ball.radius * 0.99F;
                kept.ray.direction = glm::vec3(normalize(glm::dvec3(ball.centre) - glm::dvec3(hit.ray.origin)));
                miss.ray.t_min = last;
        }
        add_pair(shots, kept, miss, random);
    }
    return shots;
}

// Rays that touch, each beside one that passes: all numbers are small integers times a power of two, so that the
// discriminant is exactly 0 in every formula. From two radii away it is still exact, or right to a part in 2^15, for
// lines that are a 2^-21st of the radius beside the tangent: these pass or enter, and are no longer the same as
// touching.
std::vector<BallShot> tangent(Random& random)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < 120; ++i) {
        const float radius = exact_size(random);
        const glm::vec3 centre = radius * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
        const int along = static_cast<int>(random.below(3));
        const int aside = (along + 1 + static_cast<int>(random.below(2))) % 3;
        glm::vec3 touching(0);
        glm::vec3 direction(0);
        touching[along] = static_cast<float>(random.below(6) + 2);
        touching[aside] = random.below(2) == 0 ? 1 : -1;
        direction[along] = -1;
        const auto narrow = [&](std::uint32_t bits) { return std::ldexp(1.0F, -static_cast<int>(bits)); };
        glm::vec3 passing = touching;
        float beside = narrow(6);
        if (i % 3 != 0) {
            passing[along] = 2;
            beside = narrow(7 + random.below(15));
        }
        passing[aside] *= 1 + beside;
        if (i % 3 == 2) {  // the hit does not touch but enters
            touching[along] = 2;
            touching[aside] *= 1 - narrow(14 + random.below(8));
        }
        const Sphere ball{centre, radius};
        add_pair(shots, {Ray{centre + radius * touching, direction}, ball},
                 {Ray{centre + radius * passing, direction}, ball}, random);
    }
    return shots;
}

// A point at an end of the interval does not count; where the interval begins behind the origin, points there do. All
// numbers are small integers times a power of two, so that every formula finds the roots exactly: they are one length
// of the direction before and behind the one that the ray begins at. Half of the directions are of any length.
std::vector<BallShot> at_the_ends(Random& random)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < 80; ++i) {
        const float radius = exact_size(random);
        const glm::vec3 centre = radius * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
        const auto axis = random.below(3);
        glm::vec3 direction(0);
        direction[axis] = random.below(2) == 0 ? radius : -radius;
        const Sphere ball{centre, radius};
        const float length = i / 8 % 2 == 0 ? 1 : std::ldexp(1.0F, static_cast<int>(random.below(41)) - 20);
        const auto from = [&](float middle, float t_min, float t_max) {
            return BallShot{counted_in({centre - middle * direction, direction, t_min, t_max}, length), ball};
        };
        const auto in = [&](float t_min, float t_max) { return from(3, t_min, t_max); };
        BallShot touching = from(0, -1, endless);
        touching.ray.origin[(axis + 1) % 3] += radius;
        BallShot touching_at_the_end = touching;
        touching_at_the_end.ray.t_min = 0;
        switch (i % 8) {
            case 0: add_pair(shots, in(2, endless), in(4, endless), random); break;
            case 1: add_pair(shots, in(4 * barely_less, 5), in(3, 4), random); break;
            case 2: add_pair(shots, in(0, 2 * barely_more), in(0, 2), random); break;
            case 3: add_pair(shots, in(2, 4 * barely_more), in(2, 4), random); break;
            case 4: add_pair(shots, from(-3, -5, endless), from(-3, -2, endless), random); break;
            case 5: add_pair(shots, from(-3, -4, 0), from(-3, -4, -2), random); break;
            case 6: add_pair(shots, from(0, -endless, endless), from(0, -1, 1), random); break;
            default: add_pair(shots, touching, touching_at_the_end, random);
        }
    }
    return shots;
}

// Origins on the surface, where a shadow ray begins: the origin itself is no answer. With t_min = 0 the numbers are
// exact; other origins are rounded, and t_min keeps the root at the origin out.
std::vector<BallShot> from_surface(Random& random)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < 20; ++i) {
        const float radius = exact_size(random);
        const glm::vec3 centre = radius * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
        const auto along = random.below(3);
        glm::vec3 outwards(0);
        outwards[along] = random.below(2) == 0 ? 1 : -1;
        glm::vec3 touching(0);
        touching[(along + 1) % 3] = 1;
        const glm::vec3 origin = centre + radius * outwards;
        const Sphere ball{centre, radius};
        add_pair(shots, {Ray{origin, -outwards}, ball}, {Ray{origin, i % 2 == 0 ? outwards : touching}, ball}, random);
    }
    for (int i = 0; i < 100; ++i) {
        const Sphere ball = random_ball(random);
        const glm::dvec3 outwards(random.unit_vector());
        const glm::dvec3 inwards = -outwards + 0.9 * random.uniform_double() * perpendicular_to(outwards, random);
        const glm::vec3 origin(glm::dvec3(ball.centre) + double{ball.radius} * outwards);
        const Ray ray{origin, glm::vec3(normalize(inwards)), 0.001F * ball.radius};
        Ray away = ray;
        away.direction = -away.direction;
        add_pair(shots, {ray, ball}, {away, ball}, random);
    }
    return shots;
}

// From a point of the surface through the centre, by exact numbers.
BallShot across(Random& random)
{
    const float radius = exact_size(random);
    const glm::vec3 centre = radius * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
    glm::vec3 inwards(0);
    inwards[random.below(3)] = random.below(2) == 0 ? radius : -radius;
    return {Ray{centre - inwards, inwards}, {centre, radius}};
}

// Rays without a direction, or with NaN in them, in the ends of the interval too, from outside, from inside, and from
// the surface itself, with its point inside the interval; each has a twin without fault.
std::vector<BallShot> no_rays(Random& random)
{
    std::vector<BallShot> shots;
    for (int i = 0; i < 72; ++i) {
        const int kind = i % 12;
        const bool on_surface = kind == 2 || kind == 4;
        const BallShot hit =
            on_surface ? across(random) : aimed(random_ball(random), i % 2 == 0 ? 3 : 0.5, 0.25, random);
        BallShot none = hit;
        const auto axis = random.below(3);
        if (kind < 4)
            none.ray.direction = glm::vec3(0);
        else if (kind < 6)
            none.ray.direction[axis] = not_a_number;
        else if (kind < 8)
            none.ray.origin[axis] = not_a_number;
        else
            (kind < 10 ? none.ray.t_min : none.ray.t_max) = not_a_number;
        if (kind == 10) none.ray.t_min = not_a_number;
        if (on_surface) none.ray.t_min = -1;
        add_pair(shots, hit, none, random);
    }
    return shots;
}

// The same lines with directions of all lengths: t counts in them, and is as large as 1e10 in short ones.
std::vector<BallShot> long_direction(Random& random)
{
    std::vector<BallShot> shots = random_pairs(random, 200);
    for (std::size_t i = 0; i < shots.size(); i += 2) {
        const float length = std::pow(10.0F, random.uniform(-9, 9));
        shots[i].ray.direction *= length;
        shots[i + 1].ray.direction *= length;
    }
    return shots;
}

void record_silhouette(Random& random, Recorder& out)
{
    // The course's own example: at 5000 radii the school formula sees no difference between b² and 4ac.
    std::vector<BallShot> shots = {{Ray{{0.5F, 0, 5000}}, {{0, 0, 0}, 1}}, {Ray{{1.5F, 0, 5000}}, {{0, 0, 0}, 1}}};
    for (const double distance : {1e2, 1e4, 1e6}) {
        const std::vector<BallShot> more = silhouette_pairs(random, distance, 300, 3);
        shots.insert(shots.end(), more.begin(), more.end());
    }
    for (const BallShot& shot : shots) {
        out.append("t", ask<intersect>(out, shot.ray, shot.ball));
        out.append("t.margin", silhouette_margin(shot));
    }
}

std::vector<Sphere> three_spheres()
{
    return {{{-0.55F, 0.05F, -4.2F}, 0.75F}, {{0.5F, -0.2F, -3.4F}, 0.5F}, {{0.3F, 0.75F, -5}, 0.8F}};
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int size = 256;
    const glm::vec3 eye = vary.near(glm::vec3(0, 0.1F, 0), 0.25F);
    Grid<glm::vec3> normals(size, size);
    Grid<std::uint32_t> ids(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const BallHit hit = nearest(out, pixel_ray(eye, 0.36F, size, x, y), three_spheres());
            ids.at(x, y) = hit.id;
            normals.at(x, y) = hit.normal;
        }
    }
    out.image("normals", normals);
    out.buffer("ids", ids);
}

}

const Driver driver = {
    {"head-on", [](Case& c, Recorder& out) { record(out, head_on(c.vary)); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_pairs(c.random, 2000)); }},
    {"inside", [](Case& c, Recorder& out) { record(out, from_inside(c.random)); }},
    {"behind and before", [](Case& c, Recorder& out) { record(out, behind_and_before(c.random)); }},
    {"tangent", [](Case& c, Recorder& out) { record(out, tangent(c.random)); }},
    {"ends", [](Case& c, Recorder& out) { record(out, at_the_ends(c.random)); }},
    {"from the surface", [](Case& c, Recorder& out) { record(out, from_surface(c.random)); }},
    {"no ray", [](Case& c, Recorder& out) { record(out, no_rays(c.random)); }},
    {"long direction", [](Case& c, Recorder& out) { record(out, long_direction(c.random)); }},
    {"far away", [](Case& c, Recorder& out) { record_silhouette(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
