#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "glances.hpp"
#include "glass.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record_mirrored(Recorder& out, const glm::vec3& v, const glm::vec3& n)
{
    out.append("mirrored", ask<mirrored_direction>(out, v, n));
}

void record_refracted(Recorder& out, const SurfaceGlance& glance)
{
    out.append("refracted", ask<refracted_direction>(out, glance.v, glance.n, glance.outside, glance.inside));
}

void record_by_hand(Variation& vary, Recorder& out)
{
    const float half = 0.70710678F;
    const std::pair<glm::vec3, glm::vec3> mirrors[] = {
        {{0.6F, 0.8F, 0}, {0, 1, 0}}, {{0.6F, -0.8F, 0}, {0, 1, 0}}, {{half, half, 0}, {1, 0, 0}},
        {{0, 0, 1}, {0, 0, 1}},       {{0, 0.8F, 0.6F}, {0, 0, -1}}, {{1, 0, 0}, {half, 0, half}},
        {{1, 0, 0}, {0, 1, 0}},       {{0, 1, 0}, {0, half, -half}}, {{0, -0.6F, 0.8F}, {0.6F, 0.8F, 0}},
    };
    // Turned by quarters of a turn, which round nothing.
    for (const auto& [v, n] : mirrors) {
        const ExactMap map = vary.exact_map(0);
        record_mirrored(out, map.place(v), map.place(n));
    }

    const SurfaceGlance glances[] = {
        {{half, half, 0}, {0, 1, 0}, 1, 1.5F},
        {{0, 1, 0}, {0, 1, 0}, 1, 1.5F},
        {{0.6F, 0, 0.8F}, {0, 0, 1}, 1, 1.5F},
        {{0.6F, 0, -0.8F}, {0, 0, 1}, 1, 1.5F},
        {{0.8F, 0, -0.6F}, {0, 0, 1}, 1, 1.5F},
        {{0, -1, 0}, {0, 1, 0}, 1, 1.33F},
        {{0, 0.6F, 0.8F}, {0, 0, 1}, 1.5F, 1},
        {{0, 0.8F, 0.6F}, {0, 0, 1}, 1.5F, 1},
        {{0.8F, 0.6F, 0}, {1, 0, 0}, 1.25F, 1.25F},
        {{-0.8F, 0, 0.6F}, {1, 0, 0}, 2, 1.5F},
        {{1, 0, 0}, {0, 1, 0}, 1, 1.5F},
        {{1, 0, 0}, {0, 1, 0}, 1.5F, 1},
        {{1, 0, 0}, {0, 1, 0}, 1.25F, 1.25F},
    };
    for (const SurfaceGlance& glance : glances) {
        const ExactMap map = vary.exact_map(0);
        record_refracted(out, {map.place(glance.v), map.place(glance.n), glance.outside, glance.inside});
    }

    const std::pair<float, float> media[] = {{1.5F, 1},      {1.33F, 1},    {1, 1.5F}, {2, 1},        {1.5F, 1.5F},
                                             {2.42F, 1.33F}, {0.75F, 0.5F}, {1, 1},    {1.33F, 1.5F}, {4, 1.5F}};
    for (const auto& [from, into] : media) {
        const float other = from == into ? into : vary.scaled(into, 1.04F);
        out.append("critical", ask<critical_angle>(out, from, other));
    }
}

// No null vector, and so far from the surface and from the critical angle that the formula in float is good enough.
bool is_allowed(const SurfaceGlance& glance)
{
    const auto& [v, n, outside, inside] = glance;
    if (length(v) < 0.01F || length(n) < 0.01F || outside <= 0 || inside <= 0) return false;
    const float cosine = dot(normalize(v), normalize(n));
    const float ratio = cosine > 0 ? outside / inside : inside / outside;
    const float cosine_squared = 1 - ratio * ratio * (1 - cosine * cosine);
    return std::abs(cosine) > 0.05F && std::abs(cosine_squared) > 0.05F;
}

// One number changed alone: directions in the planes of two axes, and the same glance at other media.
void record_changed(Random& random, Recorder& out)
{
    SurfaceGlance glance = refracted_glance(random);
    for (const SurfaceGlance& changed :
         numbers_changed(random, glance, 6, [](const SurfaceGlance& one) { return is_allowed(one); })) {
        record_refracted(out, changed);
        record_mirrored(out, changed.v, changed.n);
    }
    glance.v = glance.n;
    record_refracted(out, glance);
    record_mirrored(out, glance.v, glance.n);
    const auto is_clear = [](const auto& media) {
        const auto& [from, into] = media;
        return from > 0 && into > 0 && (into < 0.9F * from || into > 1.1F * from);
    };
    for (const auto& [from, into] : numbers_changed(random, std::pair(glance.outside, glance.inside), 2, is_clear))
        out.append("critical", ask<critical_angle>(out, from, into));
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 v = random.unit_vector();
        record_mirrored(out, v, random.unit_vector());
        SurfaceGlance glance = refracted_glance(random);
        // Every sixth time the media are hardly different.
        const float hardly = std::pow(10.0F, random.uniform(-5, -2)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        if (i % 6 == 0) glance.inside = glance.outside * (1 + hardly);
        // Every sixth time light goes on into a far denser one.
        if (i % 6 == 3) {
            const float rare = random.uniform(1, 1.5F);
            const float dense = rare * std::pow(10.0F, random.uniform(1, 4));
            glance = arriving(rare, dense, 0.98 * random.uniform_double(), random);
        }
        record_refracted(out, glance);
        if (i % 10 == 0) record_changed(random, out);
        auto [rare, dense] = random_indices(random);
        // Media that are nearly the same, and media that have little in common. Next to a power of two the quotient is
        // exact: nothing is lost in float.
        if (i % 3 == 0) dense = rare * (1 + std::pow(10.0F, random.uniform(-3, 2)));
        if (i % 6 == 1) {
            dense = std::exp2(static_cast<float>(random.below(3)));
            rare = dense * (1 - std::exp2(random.uniform(-23, -7)));
        }
        const bool comes_out = random.below(3) == 0;
        out.append("critical", ask<critical_angle>(out, comes_out ? rare : dense, comes_out ? dense : rare));
    }
}

// Total reflection, and as many rays that come through.
void record_total(Random& random, Recorder& out)
{
    for (int i = 0; i < 160; ++i)
        record_refracted(out, random.below(2) == 0 ? total_glance(random) : refracted_glance(random));
}

// Light that arrives nearly along the normal, exactly along it, along the surface, or nearly so from either side; and
// media that are the same, or nearly so. Every second v is not unit.
void record_edges(Random& random, Recorder& out)
{
    for (int i = 0; i < 72; ++i) {
        const auto [rare, dense] = random_indices(random);
        const bool swapped = random.below(2) == 0;
        const float outside = swapped ? dense : rare;
        const float inside = swapped ? rare : dense;
        glm::vec3 n(0);
        n[i % 3] = random.below(2) == 0 ? 1 : -1;
        glm::vec3 across(0);
        across[(i + 1) % 3] = random.below(2) == 0 ? 1 : -1;
        // Every second n is the opposite of an axis, with zeros that are -0: then all products of n and an axis are.
        if (i % 2 == 0) {
            n = abs(n) * -1.0F;
            across = abs(across);
        }
        const glm::vec3 near_normal = normalize(n + std::pow(10.0F, random.uniform(-5, -3)) * across);
        const float aside = std::pow(10.0F, random.uniform(-6, -2)) * (random.below(2) == 0 ? 1.0F : -1.0F);
        const glm::vec3 near_surface = normalize(across + aside * n);
        const float longer = i % 2 == 0 ? 1.0F : std::ldexp(1.0F, static_cast<int>(random.below(21)) - 10);
        const auto add = [&](const glm::vec3& v, const glm::vec3& normal, float out_there, float in_there) {
            record_refracted(out, {longer * v, normal, out_there, in_there});
        };
        switch (i / 3 % 6) {
            case 0: add(n, n, outside, inside); break;
            case 1: add(-n, n, outside, inside); break;
            case 2: add(random.below(2) == 0 ? near_normal : -near_normal, n, outside, inside); break;
            case 3: add(across, n, rare, dense); break;
            case 4: add(near_surface, n, outside, inside); break;
            default: {
                const glm::vec3 v = normalize(n + random.uniform(-1.5F, 1.5F) * across);
                const float other = i / 18 % 2 == 0 ? dense : dense * (1 + std::pow(10.0F, random.uniform(-4, -2)));
                add(random.below(2) == 0 ? v : -v, n, dense, other);
            }
        }
        for (const glm::vec3& v : {i % 2 == 0 ? across : near_normal, near_surface}) record_mirrored(out, v, n);
    }
}

// The same directions with vectors of all lengths, both short, both long, or one of each; every third time hardly
// longer or shorter than unit. Some media are the same on both sides.
void record_lengths(Random& random, Recorder& out)
{
    const auto stretched = [&](const glm::vec3& v) {
        const bool shorter = random.below(2) == 0;
        const float hardly = std::pow(10.0F, random.uniform(-4, -1));
        const float far = shorter ? random.uniform(-6, -0.5F) : random.uniform(0.5F, 6);
        return v * (random.below(3) == 0 ? 1 + (shorter ? -hardly : hardly) : std::pow(10.0F, far));
    };
    for (int i = 0; i < 120; ++i) {
        SurfaceGlance glance = i % 3 == 0 ? total_glance(random) : refracted_glance(random);
        if (i % 8 == 4) glance.inside = glance.outside;
        glance.v = stretched(glance.v);
        glance.n = stretched(glance.n);
        record_refracted(out, glance);
        record_mirrored(out, glance.v, glance.n);
    }
}

void record_critical(Random& random, Recorder& out)
{
    for (const SurfaceGlance& glance : critical_glances(random, 160)) record_refracted(out, glance);
    for (int i = 0; i < 120; ++i) record_refracted(out, exactly_critical_glance(random));
}

void record_grazing(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const SurfaceGlance glance = grazing_glance(random);
        record_refracted(out, glance);
        record_mirrored(out, glance.v, glance.n);
    }
}

void record_critical_angles(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const auto [rare, dense] = hard_indices(random, i);
        const bool comes_out = random.below(4) == 0;
        out.append("critical", ask<critical_angle>(out, comes_out ? rare : dense, comes_out ? dense : rare));
    }
}

void record_picture(Variation& vary, Recorder& out)
{
    constexpr int width = 288;
    constexpr int height = 192;
    const Camera camera = varied(vary, {{0.35F, 1.75F, 6.6F}, {0, 0.86F, 0}, 0.335F});
    out.image("glass", ray_traced(width, height, camera,
                                  [](const Ray& ray) { return glass_light(ray.origin, ray.direction, 7); }));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"total reflection", [](Case& c, Recorder& out) { record_total(c.random, out); }},
    {"edges", [](Case& c, Recorder& out) { record_edges(c.random, out); }},
    {"lengths", [](Case& c, Recorder& out) { record_lengths(c.random, out); }},
    {"near the critical angle", [](Case& c, Recorder& out) { record_critical(c.random, out); }},
    {"grazing", [](Case& c, Recorder& out) { record_grazing(c.random, out); }},
    {"critical angles", [](Case& c, Recorder& out) { record_critical_angles(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
