#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "bodies.hpp"
#include "sponge.hpp"

namespace umbral {
namespace {

using namespace raytracing;
using namespace raytracing::sdf;

void distances_by_hand(Variation& vary, Recorder& out)
{
    // Places and sizes a little beside; what is zero remains zero.
    const auto near = [&](glm::vec3 p) {
        for (int i = 0; i < 3; ++i)
            if (p[i] != 0) p[i] = vary.near(p[i], 0.2F);
        return p;
    };
    for (const glm::vec3 p : {glm::vec3(3, 4, 0), {0, 0, 1}, {0, 0, 0}, {-2, 1, -2}, {2, 0, 0}})
        out.append("ball", ask<ball_distance>(out, near(p), vary.near(2.0F, 0.2F)));
    for (const glm::vec3 p :
         {glm::vec3(4, 0, 0), {4, 6, 0}, {-4, -6, 15}, {0, 0, 0}, {0.5F, 0, 0}, {0, 1.5F, 2.75F}, {1, 2, 3}})
        out.append("box", ask<box_distance>(out, near(p), near({1, 2, 3})));
    out.append("box", ask<box_distance>(out, near({3, 4, 0}), glm::vec3(0)));
    out.append("box", ask<box_distance>(out, near({0.5F, 3, -0.25F}), near({2, 0, 2})));
    for (const glm::vec3 p :
         {glm::vec3(3, 0, 0), {0, 0, -4}, {0, 0, 0}, {0, 4, 0}, {6, 4, 0}, {3, 1, 0}, {0, -4, -6}, {2, 0.5F, 0}})
        out.append("torus", ask<torus_distance>(out, near(p), vary.near(3.0F, 0.2F), vary.near(1.0F, 0.2F)));
    const glm::vec3 a = near({1, 0, 0});
    const glm::vec3 b = near({5, 0, 0});
    for (const glm::vec3 p : {glm::vec3(3, 4, 0), {-2, 4, 0}, {8, 0, 4}, {2, 0, 0}, {3, 0.5F, 0}, {0.5F, 0, 0}})
        out.append("capsule", ask<capsule_distance>(out, near(p), a, b, vary.near(1.0F, 0.2F)));
    out.append("capsule", ask<capsule_distance>(out, near({4, 4, 0}), a, a, vary.near(2.0F, 0.2F)));
    out.append("capsule", ask<capsule_distance>(out, near({3, 4, 1}), near({0, 0, 1}), near({0, 0, 9}), 0.5F));
}

// Every third time all lengths are a power of two times as large, from 1e-8 to 1e8, and every second of these times
// smaller than 1e-6; the answers, divided by it, are as exact as the others.
void random_distances(Recorder& out, Random& random)
{
    for (int i = 0; i < 200; ++i) {
        const int exponent = static_cast<int>(random.below(i % 6 == 0 ? 5 : 53)) - 26;
        const float size = i % 3 == 0 ? std::ldexp(1.0F, exponent) : 1.0F;
        const glm::vec3 p = (i % 4 == 0 ? 8 * size : 2 * size) * random.in_cube();
        const float small = size * random.uniform(0.1F, 1);
        const float large = size * random.uniform(1, 2.5F);
        out.append("ball", ask<ball_distance>(out, p, large) / size);
        const glm::vec3 half(random.uniform(0, 2), random.uniform(0, 2), random.uniform(0.5F, 2));
        out.append("box", ask<box_distance>(out, p, size * half) / size);
        out.append("torus", ask<torus_distance>(out, p, large, small) / size);
        const glm::vec3 a = 2 * size * random.in_cube();
        glm::vec3 b = i % 10 < 2 ? a : 2 * size * random.in_cube();
        if (i % 10 == 1) b[i / 10 % 3] += size * random.uniform(1, 3);  // along an axis
        out.append("capsule", ask<capsule_distance>(out, p, a, b, small) / size);
    }
}

// The same questions with one number changed alone, so that they have coordinates and sizes of 0, and equal ones.
void distances_changed(Recorder& out, Random& random)
{
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 p = 3.0F * random.in_cube();
        const float small = random.uniform(0.1F, 1);
        const float large = random.uniform(1, 2.5F);
        for (const auto& [q, radius] : numbers_changed(random, std::tuple(p, large), 4))
            out.append("ball", ask<ball_distance>(out, q, radius));
        for (const auto& [q, half] : numbers_changed(random, std::tuple(p, large + 0.9F * random.in_cube()), 5))
            out.append("box", ask<box_distance>(out, q, half));
        const auto is_torus = [](const auto& q) { return std::get<1>(q) >= std::get<2>(q) && std::get<2>(q) > 0; };
        for (const auto& [q, major, minor] : numbers_changed(random, std::tuple(p, large, small), 5, is_torus))
            out.append("torus", ask<torus_distance>(out, q, major, minor));
        const auto is_capsule = [](const auto& one) { return std::get<3>(one) > 0; };
        const std::tuple capsule(p, 2.0F * random.in_cube(), 2.0F * random.in_cube(), small);
        for (const auto& [q, a, b, radius] : numbers_changed(random, capsule, 8, is_capsule))
            out.append("capsule", ask<capsule_distance>(out, q, a, b, radius));
    }
}

// Within the box, before the mouths of its tunnels on all sides, and far away.
void sponge(Recorder& out, Random& random)
{
    for (const glm::vec3 p : {glm::vec3(0, 0, 0),
                              {0, 0, 1},
                              {0.5F, 0, 0},
                              {2.0F / 3, 2.0F / 3, 0},
                              {0.9F, 0.8F, 0.7F},
                              {0, 0, 3},
                              {3, 5, 1},
                              {-2.0F / 3, 2.0F / 3, 1},
                              {-1.125F, 0.125F, 0},
                              {0.125F, -1.0625F, -0.0625F},
                              {-0.125F, 0.0625F, -1.25F}})
        for (int level = 0; level <= 2; ++level) out.append("distance", ask<menger_distance>(out, p, level));
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 p = (i % 5 == 0 ? 1.25F : i % 5 == 1 ? 9.0F : 1.0F) * random.in_cube();
        out.append("distance", ask<menger_distance>(out, p, i % 3 == 0 ? 6 : static_cast<int>(random.below(7))));
    }
}

// `length` is a power of two, in whose units t is recorded.
void record(Recorder& out, const TraceShot& shot, float length = 1)
{
    const auto found = ask<sphere_trace>(out, shot.ray, std::span<const DistanceFunction>(shot.bodies), shot.limits);
    out.append("t", found ? std::optional(length * found->t) : std::nullopt);
    out.append("object", found ? std::optional(static_cast<float>(found->object)) : std::nullopt);
}

void record_pair(Recorder& out, const TraceShot& hit, const TraceShot& miss, Random& random)
{
    const bool swapped = random.below(2) == 1;
    record(out, swapped ? miss : hit);
    record(out, swapped ? hit : miss);
}

// Planes and balls met head-on: two steps, exact.
void traces_by_hand(Variation& vary, Recorder& out)
{
    // All lengths are multiplied by the same: t too.
    const float size = other_size(vary);
    const auto record_sized = [&](TraceShot shot) {
        shot.ray = sized(shot.ray, size);
        record(out, shot);
    };
    const auto ground = [] { return half_space({0, 1, 0}, 0); };
    const auto ball = [size] { return ball_at({0, size * 5, 0}, size); };
    const Ray down{{0, 3, 0}, {0, -1, 0}};
    const Ray up{{0, 3, 0}, {0, 1, 0}};
    const TraceLimits limits{1e-4F, 64};
    record_sized({down, {ground()}, limits});
    record_sized({down, {ball(), ground()}, limits});
    record_sized({up, {ground(), ball()}, limits});
    record_sized({up, {ground()}, limits});
    record_sized({down, {}, limits});
    record_sized({down, {ball(), ground(), ground()}, limits});
    record_sized({up, {ball(), ground(), ball()}, limits});
    record_sized({{{7, 4, 0}, {0, -2, 0}}, {ground(), ground(), ball(), ground()}, limits});
    record_sized({{{0, 5, 0}, {1, 0, 0}}, {ground(), ball()}, limits});
    record_sized({{{0, 5.25F, 0}, {0, -1, 0}}, {ball()}, limits});
    record_sized({{{0, -2, 0}, {0, 1, 0}}, {ground()}, limits});
    record_sized({{{0, 0, 0}, {0, 1, 0}}, {ball(), ground()}, limits});
    record_sized({{{0, 0, 0}, {0, 1, 0}, 0.5F}, {ball(), ground()}, limits});
    record_sized({{{0, 8, 0}, {0, -2, 0}}, {ball(), ground()}, limits});
    record_sized({{{0, 8, 0}, {0, -2, 0}, 1.75F}, {ball(), ground()}, limits});
    record_sized({{{0, 3, 0}, {0, 1, 0}, -2}, {half_space({0, -1, 0}, size * -2)}, limits});
    // Both are within the tolerance of the last point; the second one is nearer.
    record_sized({down, {ground(), half_space({0, 1, 0}, 0x1p-11F)}, {0x1p-10F, 64}});
}

// Every third time all lengths are a power of two times as large, the tolerance too, and every second of these times so
// large that the balls are 1e5 to 1e6 away; t is divided by it. Every other direction is longer or shorter, down to
// 1e-12.
void random_traces(Recorder& out, Random& random)
{
    for (int i = 0; i < 300; ++i) {
        Balls all = random_balls(random, 1 + static_cast<int>(random.below(6)));
        Ray ray = clear_ray(all, random);
        const int exponent = static_cast<int>(i % 6 == 0 ? 21 + random.below(4) : random.below(21)) - 8;
        const float size = i % 3 == 0 ? std::ldexp(1.0F, exponent) : 1;
        for (glm::vec4& ball : all.balls) ball *= size;
        ray.origin *= size;
        const float longer = i % 2 == 0 ? 1 : std::ldexp(1.0F, static_cast<int>(random.below(61)) - 40);
        ray.direction *= longer;
        record(out, {ray, all.bodies(), {1e-4F * size, 400}}, longer / size);
    }
}

// The same ray to other bodies, and other rays to the same: each differs in one number from the one before. At last
// there are no bodies.
void traces_changed(Recorder& out, Random& random)
{
    for (int i = 0; i < 20; ++i) {
        const Balls all = random_balls(random, 1 + i % 3);
        Ray ray = clear_ray(all, random);
        ray.t_min = random.uniform(0.2F, 2);
        ray.t_max = random.uniform(18, 30);
        const float longer = i % 4 == 0 ? 1 : std::ldexp(1.0F, static_cast<int>(random.below(61)) - 40);
        for (const auto& [asked, balls] : numbers_changed(random, Walk(ray, all), 8, is_clear))
            if (is_clear({asked, balls}))
                record(out, {counted_in(asked, longer), balls.bodies(), {1e-4F, 400}}, longer);
        if (i % 4 == 0) record(out, {ray, {}, {1e-4F, 400}});
    }
}

// From within a ball: the surface of the union is met from its inside, where the balls overlap too.
void from_inside(Recorder& out, Random& random)
{
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 way = random.unit_vector();
        const glm::vec3 centre = 3.0F * random.in_cube();
        const float radius = random.uniform(0.6F, 1.2F);
        // The second one holds the point where the ray leaves the first; in every third question there is none.
        const glm::vec3 second = centre + radius * way + 0.15F * random.in_cube();
        Bodies bodies{ball_at(centre, radius), ball_at(second, 0.5F)};
        if (i % 3 == 0) bodies.pop_back();
        if (i % 3 == 1) std::swap(bodies[0], bodies[1]);
        record(out, {{centre - 0.3F * radius * random.unit_vector(), way}, bodies, {1e-4F, 400}});
    }
}

// Where the interval of the ray decides, the number of steps, or the tolerance; with exact steps.
void limits(Recorder& out, Random& random)
{
    for (int i = 0; i < 90; ++i) {
        const glm::vec3 way = random.unit_vector();
        const glm::vec3 origin = 2.0F * random.in_cube();
        const glm::vec3 axis(1, 0, 0);
        const float far = random.uniform(2, 6);
        // Each step halves the way that is left: after j points it is 2^-j.
        const auto halving = [] { return counted([](const glm::vec3& p) { return 0.5F * (1 - p.x); }); };
        const int j = 3 + static_cast<int>(random.below(12));
        const float tolerance = std::exp2(static_cast<float>(-j));
        const auto ball = [&] { return ball_at(origin + (far + 1) * way, 1); };
        const auto wall = [&] { return half_space({-1, 0, 0}, -far); };
        const auto at = [&](float t_min, float t_max) {
            return TraceShot{{origin, way, t_min, t_max}, {ball()}, {1e-4F, 64}};
        };
        switch (i % 9) {
            case 0: record_pair(out, at(0, far + 0.1F), at(0, far - 0.1F), random); break;
            case 1: record_pair(out, at(far - 0.2F, endless), at(far + 2.2F, endless), random); break;
            case 2: {
                TraceShot behind = at(0, endless);
                behind.ray.direction = -way;
                TraceShot before = behind;
                before.ray.t_min = -far - 3;
                record_pair(out, before, behind, random);
                break;
            }
            case 3:
                if (i % 18 == 3) {
                    const int steps = 100 + static_cast<int>(random.below(1000));
                    const auto body = [&] { return in_steps(static_cast<float>(steps) / 64, 1.0F / 64); };
                    record_pair(out, {{{0, 0, 0}, axis}, {body()}, {1e-4F, steps + 1}},
                                {{{0, 0, 0}, axis}, {body()}, {1e-4F, steps}}, random);
                    break;
                }
                record_pair(out, {{{0, 0, 0}, axis}, {halving()}, {tolerance, j}},
                            {{{0, 0, 0}, axis}, {halving()}, {tolerance, j - 1}}, random);
                break;
            case 4:
                record_pair(out, {{{0, 0, 0}, axis}, {halving()}, {tolerance, j}},
                            {{{0, 0, 0}, axis}, {halving()}, {0.75F * tolerance, j}}, random);
                break;
            case 5:
                record_pair(out, {{{0, 0, 0}, axis, 0, far + 0.01F}, {wall()}, {1e-5F, 8}},
                            {{{0, 0, 0}, axis, 0, far}, {wall()}, {1e-5F, 8}}, random);
                break;
            case 6:
                record_pair(out, {{origin, way}, {everywhere(0.25F)}, {0.25F, 50}},
                            {{origin, way}, {everywhere(0.25F)}, {0.125F, 50}}, random);
                break;
            case 7: {
                // Far away, t counted in as many units: two steps are enough.
                const float away = std::exp2(random.uniform(14.5F, 20));
                const auto far_ball = [&] { return ball_at(origin + 2 * away * way, away); };
                record_pair(out, {{origin, away * way}, {far_ball()}, {1e-4F * away, 3}},
                            {{origin, away * way}, {far_ball()}, {1e-4F * away, 1}}, random);
                break;
            }
            default:
                record_pair(out, {{origin, way, 0.25F}, {everywhere(0.25F)}, {0.25F, 1}},
                            {{origin, way, 0.25F}, {everywhere(0.25F)}, {0.25F, 0}}, random);
        }
    }
}

void record_picture(Variation& vary, Recorder& out)
{
    ask_in_words(out,
                 [] { return "sphere_trace(ray, {menger_distance of level 3}, {4e-4F, 90}) // rays for each pixel"; });
    out.image("sponge", sponge_picture(vary));
}

}

const Driver driver = {
    {"distances by hand", [](Case& c, Recorder& out) { distances_by_hand(c.vary, out); }},
    {"random distances",
     [](Case& c, Recorder& out) {
         random_distances(out, c.random);
         distances_changed(out, c.random);
     }},
    {"sponge", [](Case& c, Recorder& out) { sponge(out, c.random); }},
    {"by hand", [](Case& c, Recorder& out) { traces_by_hand(c.vary, out); }},
    {"random",
     [](Case& c, Recorder& out) {
         random_traces(out, c.random);
         traces_changed(out, c.random);
     }},
    {"from inside", [](Case& c, Recorder& out) { from_inside(out, c.random); }},
    {"limits", [](Case& c, Recorder& out) { limits(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
