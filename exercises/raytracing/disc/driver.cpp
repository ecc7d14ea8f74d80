#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "sequins.hpp"
#include "shots.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record(Recorder& out, const std::vector<DiscShot>& shots)
{
    for (const auto& [ray, disc] : shots) out.append("t", ask<intersect_disc>(out, ray, disc));
}

// Answers that a student can check by hand, the course's first; each has a twin that passes beside the disc.
std::vector<DiscShot> by_hand(Variation& vary)
{
    std::vector<DiscShot> shots;
    const auto add = [&](glm::vec3 origin, glm::vec3 direction, Disc disc, glm::vec3 aside) {
        const float size = other_size(vary);
        const Disc other{size * disc.centre, disc.normal, size * disc.radius};
        shots.push_back({sized(Ray{origin, direction}, size), other});
        shots.push_back({sized(Ray{origin + aside, direction}, size), other});
    };
    const Disc unit{{0, 0, 0}, {0, 0, 1}, 1};
    add({0.5F, 0, 3}, {0, 0, -1}, unit, {1, 0, 0});
    add({0.5F, 0, 3}, {0, 0, -1}, {{0, 0, 0}, {0, 0, 7}, 1}, {0, 1, 0});
    add({0.5F, 0, 3}, {0, 0, -1}, {{0, 0, 0}, {0, 0, -1}, 1}, {-2, 0, 0});
    add({0, 0.5F, -3}, {0, 0, 1}, unit, {0.75F, 0.75F, 0});
    add({0, 0, 4}, {1, 0, -2}, {{2, 0, 0}, {0, 0, 1}, 0.5F}, {-2, 0, 0});
    add({1, 2, 10}, {0, 0, -1}, {{1, 0, 3}, {0, 0, 2}, 3}, {2.5F, 0, 0});
    add({-7, 1, 1}, {1, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 2}, {0, 2, 0});
    add({2, 9, 2}, {0, -1, 0}, {{2, -1, 2}, {0, 1, 0}, 0.25F}, {0.25F, 0, 0.25F});
    add({4, 0, 0}, {-1, 0, 0}, {{0, 0, 0}, {1, 1, 0}, 3}, {0, 4, 0});
    add({0, 5, 0}, {0, -1, 0}, {{0, 1, 1}, {0, 1, 2}, 4}, {0, 0, -4});
    add({3, 0, 4}, {0, 0, -1}, {{0, 0, 0}, {0, 0, 1}, 3.25F}, {0.5F, 0, 0});
    add({0, 3, 2}, {0, 0, -2}, {{0, 0, -2}, {0, 0, 1}, 4}, {3, 0, 0});
    return in_pairs(vary, std::move(shots));
}

// Rays along an axis onto discs across it, with small integers times a power of two: all that decides is exact.
DiscShot exact_shot(Random& random, glm::vec2 place, float height, float radius)
{
    const float scale = exact_size(random);
    const glm::vec3 centre = scale * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
    const int along = static_cast<int>(random.below(3));
    glm::vec3 normal(0);
    normal[along] = random.below(2) == 0 ? 2 : -1;
    glm::vec3 origin(0);
    origin[along] = random.below(2) == 0 ? height : -height;
    glm::vec3 direction(0);
    direction[along] = origin[along] > 0 ? -scale : scale;
    origin[(along + 1) % 3] = place.x;
    origin[(along + 2) % 3] = place.y;
    return {Ray{centre + scale * origin, direction}, {centre, normal, radius * scale}};
}

// The rim does not belong to the disc: rays through its points 5² = 3² + 4² miss, and those a little nearer hit.
std::vector<DiscShot> at_the_rim(Random& random)
{
    const glm::vec2 places[] = {{3, 4}, {-4, 3}, {5, 0}, {0, -5}, {-3, -4}, {4, -3}};
    std::vector<DiscShot> shots;
    for (int i = 0; i < 60; ++i) {
        const glm::vec2 place = places[i % 6];
        const DiscShot miss = exact_shot(random, place, 3, 5);
        DiscShot hit = miss;
        hit.disc.radius *= i % 2 == 0 ? 1.015625F : barely_more;
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

// From just above the disc, away from its centre, and yet into it; the twin meets its plane beyond the rim.
void shots_away_from_the_centre(std::vector<DiscShot>& shots, Random& random)
{
    const Disc disc = random_disc(random);
    const glm::vec3 normal = normalize(disc.normal);
    const glm::vec3 outwards = disc.radius * normalize(cross(normal, random.unit_vector()));
    const glm::vec3 from = disc.centre + 0.3F * outwards + 0.05F * disc.radius * normal;
    const auto towards = [&](float place) {
        return DiscShot{{from, disc.centre + place * outwards - from, 0, endless}, disc};
    };
    add_pair(shots, towards(random.uniform(0.6F, 0.9F)), towards(random.uniform(1.1F, 1.4F)), random);
}

// Where the interval (t_min, t_max) decides: the disc lies behind, before t_min, or beyond t_max; and the same on the
// other side of the origin, where t is negative and the interval admits that.
std::vector<DiscShot> behind_and_before(Random& random)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < 180; ++i) {
        const Disc disc = random_disc(random);
        const float distance = random.uniform(2, 6);
        const DiscShot ahead = aimed(disc, offset_inside(0.9, random), random.uniform(0.2F, 1), distance, random);
        const float t = distance * disc.radius;
        DiscShot behind = ahead;
        behind.ray.direction = -behind.ray.direction;
        const auto in = [](DiscShot shot, float t_min, float t_max) {
            shot.ray.t_min = t_min;
            shot.ray.t_max = t_max;
            return shot;
        };
        switch (i % 6) {
            case 0: add_pair(shots, ahead, behind, random); break;
            case 1: add_pair(shots, in(ahead, 0.99F * t, endless), in(ahead, 1.01F * t, endless), random); break;
            case 2: add_pair(shots, in(ahead, 0, 1.01F * t), in(ahead, 0, 0.99F * t), random); break;
            case 3: add_pair(shots, in(behind, -1.01F * t, endless), in(behind, -0.99F * t, endless), random); break;
            case 4: add_pair(shots, in(behind, -endless, -0.99F * t), in(behind, -endless, -1.01F * t), random); break;
            default: add_pair(shots, in(behind, -2 * t, t), in(ahead, -2 * t, 0.99F * t), random);
        }
    }
    for (int i = 0; i < 30; ++i) shots_away_from_the_centre(shots, random);
    // The same by longer directions, so that the ends of the interval are fractions of 1.
    for (std::size_t i = 0; i < shots.size(); ++i)
        if (i / 2 % 3 == 0) shots[i].ray = counted_in(shots[i].ray, 32);
    return shots;
}

// A point at an end of the interval does not count; where the interval begins behind the origin, points there do. The
// disc is met at 3 or at -3 lengths of the direction, exactly, or at 0: a ray that begins on it.
std::vector<DiscShot> at_the_ends(Random& random)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < 80; ++i) {
        const DiscShot ahead = exact_shot(random, {1, i % 4}, 3, 4);
        const auto in = [&](float t_min, float t_max) {
            DiscShot shot = ahead;
            shot.ray.t_min = t_min;
            shot.ray.t_max = t_max;
            return shot;
        };
        const auto turned = [&](float t_min, float t_max) {
            DiscShot shot = in(t_min, t_max);
            shot.ray.direction = -shot.ray.direction;
            return shot;
        };
        DiscShot begins_there = exact_shot(random, {1, i % 4}, 0, 4);
        DiscShot from_before = begins_there;
        from_before.ray.t_min = -1;
        switch (i % 5) {
            case 0: add_pair(shots, in(3 * barely_less, endless), in(3, endless), random); break;
            case 1: add_pair(shots, in(0, 3 * barely_more), in(0, 3), random); break;
            case 2: add_pair(shots, turned(-3 * barely_more, endless), turned(-3, endless), random); break;
            case 3: add_pair(shots, turned(-endless, -3 * barely_less), turned(-endless, -3), random); break;
            default: add_pair(shots, from_before, begins_there, random);
        }
    }
    return shots;
}

// Rays parallel to the disc, beside it and in its plane; the twin leans towards the disc by an eighth, or by so little
// that it takes a small number for 0 to call it parallel.
std::vector<DiscShot> parallel(Random& random)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < 60; ++i) {
        const DiscShot upright = exact_shot(random, {1, 0}, 1, 4);
        const glm::vec3 down = upright.ray.direction;
        glm::vec3 aside(0);
        for (int axis = 0; axis < 3; ++axis)
            if (down[axis] != 0) aside[(axis + 1 + i % 2) % 3] = i % 4 < 2 ? length(down) : -length(down);
        DiscShot hit = upright;
        const float slope = i % 5 < 3 ? 0.125F : 0x1p-18F;
        hit.ray.origin -= 2.0F * aside;
        hit.ray.direction = aside + slope * down;
        hit.ray.origin += (1 - slope) * down;
        DiscShot miss = hit;
        miss.ray.direction = aside;
        if (i % 3 > 0) miss.ray.origin += slope * down;  // into the plane, on the way through the disc
        if (i % 3 > 1) miss.ray.t_min = -endless;
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

// Rays and discs without a direction, or with NaN in them; each has a twin without fault.
std::vector<DiscShot> no_rays(Random& random)
{
    std::vector<DiscShot> shots;
    for (int i = 0; i < 40; ++i) {
        const DiscShot hit = aimed(random_disc(random), 0.5, 0.5, 3, random);
        DiscShot none = hit;
        const auto axis = random.below(3);
        switch (i % 6) {
            case 0: none.ray.direction = glm::vec3(0); break;
            case 1: none.disc.normal = glm::vec3(0); break;
            case 2: none.ray.direction[axis] = not_a_number; break;
            case 3: none.ray.origin[axis] = not_a_number; break;
            case 4: none.ray.t_min = not_a_number; break;
            default: none.ray.t_max = not_a_number;
        }
        add_pair(shots, hit, none, random);
    }
    return shots;
}

// The same lines and planes with directions and normals of all lengths: t counts in those of the direction. Every
// fourth pair has both short, and every fourth both long; of twelve, two have both so short or so long that the
// product of the two is no float.
std::vector<DiscShot> lengths(Random& random)
{
    std::vector<DiscShot> shots = random_pairs(random, 200);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const std::size_t kind = i / 2 % 4;
        const float most = i / 2 % 12 == 0 || i / 2 % 12 == 11 ? 24 : 6;
        const float least = most == 6 ? 3 : 23;
        const auto factor = [&](bool is_short) {
            return std::pow(10.0F, is_short ? random.uniform(-most, -least) : random.uniform(least, most));
        };
        shots[i].ray.direction *= factor(kind % 2 == 0);
        shots[i].disc.normal *= factor(kind < 2);
    }
    return shots;
}

// The same figures from 1e-4 to 1e6 in size.
std::vector<DiscShot> scales(Random& random)
{
    std::vector<DiscShot> shots = random_pairs(random, 200);
    for (std::size_t i = 0; i < shots.size(); i += 2) {
        const float scale = std::exp2(std::floor(random.uniform(-13, 20)));
        for (DiscShot* shot : {&shots[i], &shots[i + 1]}) {
            shot->ray.origin *= scale;
            shot->disc.centre *= scale;
            shot->disc.radius *= scale;
        }
    }
    return shots;
}

void record_remote(Random& random, Recorder& out)
{
    for (const float away : {1e4F, 1e5F, 1e6F}) record(out, remote_pairs(random, away, 100));
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int width = 288;
    constexpr int height = 224;
    const Camera camera = varied(vary, {{0, 2.3F, 6.4F}, {0, 0.8F, 0}, 0.285F});
    const std::vector<Disc> discs = sequin_ball();
    const auto asked = [&](const Ray& ray, const Disc& disc) { return ask<intersect_disc>(out, ray, disc); };
    Grid<std::uint32_t> ids(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ids.at(x, y) = nearest(asked, camera_ray(camera, width, height, glm::vec2(x, y) + 0.5F), discs).id;
    out.buffer("ids", ids);
    out.image("sequins", ray_traced(width, height, camera, [&](const Ray& ray) { return sequin_light(ray, discs); }));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, by_hand(c.vary)); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_pairs(c.random, 1000)); }},
    {"behind and before", [](Case& c, Recorder& out) { record(out, behind_and_before(c.random)); }},
    {"rim", [](Case& c, Recorder& out) { record(out, at_the_rim(c.random)); }},
    {"ends", [](Case& c, Recorder& out) { record(out, at_the_ends(c.random)); }},
    {"parallel", [](Case& c, Recorder& out) { record(out, parallel(c.random)); }},
    {"no ray", [](Case& c, Recorder& out) { record(out, no_rays(c.random)); }},
    {"lengths", [](Case& c, Recorder& out) { record(out, lengths(c.random)); }},
    {"scales", [](Case& c, Recorder& out) { record(out, scales(c.random)); }},
    {"far away", [](Case& c, Recorder& out) { record_remote(c.random, out); }},
    {"grazing", [](Case& c, Recorder& out) { record(out, grazing_pairs(c.random, 300)); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
