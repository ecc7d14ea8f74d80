#pragma once

#include <kit/channels.hpp>
#include <kit/placement.hpp>

#include "stage.hpp"

/// Single points whose place on the map, and whose distance from the border between light and shadow, is known.
namespace umbral::raytracing {

/// A point of a surface in the world, what it is given, and what the map holds: `here` in its own texel, and
/// `elsewhere` in all others.
struct ShadowProbe {
    MapLight light;
    glm::vec3 place{0};
    glm::vec3 normal{0, 1, 0};
    glm::vec3 color{1};
    glm::mat4 model{1};
    glm::ivec2 texel{0};  ///< its texel, from the lower left
    float here = nothing_seen;
    float elsewhere = 0;
};

inline double distance_of(const MapLight& light, const glm::vec3& place)
{
    const glm::dvec3 from(light.place);
    return light.place.w == 0 ? -dot(from, glm::dvec3(place)) : length(from - glm::dvec3(place));
}

/// A lamp or a sun, as often; its frustum is neither square nor, half of the time, symmetric. Of four one has near and
/// far planes that most points are not between.
inline MapLight random_light(Random& random)
{
    const glm::vec3 place = 4.0F * random.in_cube();
    const glm::vec3 target = place + random.unit_vector();
    const float wide = random.uniform(0.4F, 2.2F);
    const float high = random.uniform(0.4F, 2.2F);
    const float aside = random.below(2) == 0 ? 0.0F : random.uniform(-0.5F, 0.5F);
    const bool is_sun = random.below(2) == 0;
    MapLight light = is_sun ? sun_from(random.unit_vector(), place, glm::vec2(1)) : lamp_at(place, target, 60);
    const bool thin = random.below(4) == 0;
    const float near = thin ? 4.0F : is_sun ? 0.1F : 0.05F;
    const float far = thin ? 5.0F : 60.0F;
    const float size = is_sun ? 3.0F : near;
    const float left = size * wide * (aside - 1);
    const float right = size * wide * (aside + 1);
    light.projection = is_sun ? glm::ortho(left, right, -size * high, size * high, near, far)
                              : glm::frustum(left, right, -size * high, size * high, near, far);
    light.color = glm::vec3(0.7F) + 0.3F * random.in_cube();
    light.ambient = glm::vec3(0.12F) + 0.08F * random.in_cube();
    const auto columns = static_cast<int>(2 + random.below(20));
    const auto rows = static_cast<int>(2 + random.below(20));
    light.texels = {columns, rows == columns ? rows + 1 : rows};
    return light;
}

/// The point that the light has at `place` of its view plane, both in [-1, 1], that far along its axis.
inline glm::vec3 at_map_place(const MapLight& light, const glm::vec2& place, float distance)
{
    const glm::mat4& p = light.projection;
    const bool parallel = light.place.w == 0;
    const float scale = parallel ? 1.0F : distance;
    const glm::vec2 shift = parallel ? -glm::vec2(p[3]) : glm::vec2(p[2]);
    const glm::vec3 eye((place.x + shift.x) * scale / p[0][0], (place.y + shift.y) * scale / p[1][1], -distance);
    return glm::vec3(inverse(light.view) * glm::vec4(eye, 1));
}

inline glm::dvec3 towards_light(const MapLight& light, const glm::vec3& place)
{
    const glm::dvec3 from(light.place);
    return light.place.w == 0 ? from : normalize(from - glm::dvec3(place));
}

/// A unit normal whose cosine with the unit vector `axis` is this.
inline glm::vec3 tilted(const glm::dvec3& axis, double cosine, Random& random)
{
    const glm::dvec3 other = std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = normalize(cross(axis, other));
    const double turn = 6.283185307179586 * random.uniform_double();
    const glm::dvec3 side = std::cos(turn) * u + std::sin(turn) * cross(axis, u);
    return glm::vec3(cosine * axis + std::sqrt(1 - cosine * cosine) * side);
}

/// What is taken off the distance before it is compared, of a surface with this cosine: the statement's formula, by the
/// corners of the texel in eye coordinates.
inline double allowance(const ShadowProbe& probe, double distance_along_axis, double cosine)
{
    const double depth = probe.light.place.w == 0 ? 1 : distance_along_axis;
    const glm::dvec2 texel(2 * depth / (double{probe.light.projection[0][0]} * probe.light.texels.x),
                           2 * depth / (double{probe.light.projection[1][1]} * probe.light.texels.y));
    return 0.51 * length(texel) * std::tan(std::acos(cosine)) + 0.001;
}

/// Of probes: the cosines between their surfaces and the light, and the share of the allowance that lies between the
/// map's distance and the border between light and shadow. Maps are `finer` times as fine.
struct ProbeRange {
    double least_cosine = 0.05;
    double most_cosine = 1;
    double band = 0.01;
    int finer = 1;
};

/// Pairs, one lit and one in shadow, in random order. All other texels say the opposite. Of three points one lies
/// nearer to the light's plane than a unit, but in finer maps, where float would move it to another texel.
inline std::vector<ShadowProbe> probe_pairs(Random& random, int count, const ProbeRange& range)
{
    // Where the allowance is small, float decides.
    constexpr double least_distance = 3e-4;
    std::vector<ShadowProbe> probes;
    for (int i = 0; i < count; ++i) {
        const bool swapped = random.below(2) == 1;
        for (int k = 0; k < 2; ++k) {
            ShadowProbe probe;
            probe.light = random_light(random);
            probe.light.texels *= range.finer;
            const glm::ivec2 size = probe.light.texels;
            probe.texel = {static_cast<int>(random.below(static_cast<std::uint32_t>(size.x))),
                           static_cast<int>(random.below(static_cast<std::uint32_t>(size.y)))};
            const glm::vec2 within = glm::vec2(0.5F) + 0.47F * glm::vec2(random.in_cube());
            const glm::vec2 at = 2.0F * (glm::vec2(probe.texel) + within) / glm::vec2(size) - 1.0F;
            const bool is_near = random.below(3) == 0 && range.finer == 1;
            const float along = is_near ? std::exp2(random.uniform(-5, -1)) : random.uniform(1, 8);
            probe.place = at_map_place(probe.light, at, along);
            const double cosine =
                range.least_cosine + (range.most_cosine - range.least_cosine) * random.uniform_double();
            probe.normal = tilted(towards_light(probe.light, probe.place), cosine, random);
            probe.color = glm::vec3(0.6F) + 0.35F * random.in_cube();
            // Of four one lacks a colour: the surface, the light, or the light that is everywhere.
            glm::vec3* const colors[] = {&probe.color, &probe.light.color, &probe.light.ambient};
            glm::vec3& color = *colors[random.below(3)];
            if (random.below(4) == 0) color = without_a_channel(random, color);
            probe.model = random_placement(random);
            const bool is_lit = (k == 0) != swapped;
            const double bias = allowance(probe, double{along}, cosine);
            const double by = std::max(range.band * bias, least_distance);
            probe.here = static_cast<float>(distance_of(probe.light, probe.place) - (is_lit ? bias - by : bias + by));
            probe.elsewhere = is_lit ? -nothing_seen : nothing_seen;
            probes.push_back(probe);
        }
    }
    return probes;
}

/// Beside the map and behind the lamp, where it has nothing to say though all of its texels are in shadow; and between
/// them points on it. Of all of them every fourth one faces away from the light, which adds nothing there.
inline std::vector<ShadowProbe> probes_off_the_map(Random& random, int count)
{
    std::vector<ShadowProbe> probes = probe_pairs(random, count, {0.6, 1, 0.5});
    for (std::size_t i = 0; i < probes.size(); ++i) {
        ShadowProbe& probe = probes[i];
        const float cosine = random.uniform(0.5F, 0.95F);
        const bool faces_away = random.below(4) == 0;
        if (i % 3 == 2) {
            if (faces_away) probe.normal = -probe.normal;
            continue;
        }
        const bool behind = probe.light.place.w != 0 && i % 3 == 1;
        glm::vec2 at = 0.95F * glm::vec2(random.in_cube());
        const float outside = random.uniform(1.03F, 3);
        const bool is_negative = random.below(2) == 0;
        if (!behind) at[random.below(2) == 0 ? 0 : 1] = is_negative ? -outside : outside;
        probe.place = at_map_place(probe.light, at, random.uniform(1, 8) * (behind ? -1.0F : 1.0F));
        probe.normal = tilted(towards_light(probe.light, probe.place), faces_away ? -cosine : cosine, random);
        probe.here = probe.elsewhere = -nothing_seen;
    }
    return probes;
}

inline void feed_place(const gl::Program& program, const ShadowProbe& probe)
{
    program.set("model", probe.model);
    // Back to the coordinates of the object.
    feed(program, "position", glm::vec3(inverse(probe.model) * glm::vec4(probe.place, 1)));
}

/// The second pass of single points: colours from 0 to 1, encoded.
inline std::vector<glm::vec3> colors_of(const std::vector<ShadowProbe>& probes, const gl::Program& shadows)
{
    const auto size = static_cast<int>(probes.size());
    const gl::Framebuffer frame(size, 1);
    frame.clear({1, 0, 1, 1});
    const DistanceMap map(1, 1);
    frame.bind();
    shadows.set("view", glm::mat4(1));
    shadows.set("projection", to_centre());
    draw_single_points(size, [&](std::size_t i) {
        const ShadowProbe& probe = probes[i];
        Grid<float> cells(probe.light.texels.x, probe.light.texels.y, probe.elsewhere);
        cells.at(probe.texel.x, probe.texel.y) = probe.here;
        map.fill(cells);
        set_light(shadows, probe.light);
        feed_place(shadows, probe);
        // Through the transpose, since the shader's way is the inverse transpose.
        feed(shadows, "normal", normalize(transpose(glm::mat3(probe.model)) * probe.normal));
        feed(shadows, "color", probe.color);
    });
    std::vector<glm::vec3> colors;
    for (const glm::u8vec4& pixel : frame.read_pixels().cells) colors.push_back(glm::vec3(pixel) / 255.0F);
    return colors;
}

inline std::string map_text(const ShadowProbe& probe)
{
    return "// a map of " + std::to_string(probe.light.texels.x) + " x " + std::to_string(probe.light.texels.y) +
           " texels, of which (" + std::to_string(probe.texel.x) + ", " + std::to_string(probe.texel.y) + ") holds " +
           literal::of_value(probe.here, true, {}) + " and all others " + literal::of_value(probe.elsewhere, true, {}) +
           "\n// a point that lies here in the world:\n";
}

/// What both passes are fed with for a point, under the names that they know; its place and normal in the world.
template <class Visit>
void for_each_input(ShadowProbe& probe, const Visit& visit)
{
    visit("position", probe.place);
    visit("normal", probe.normal);
    visit("color", probe.color);
    visit("model", probe.model);
    visit("light", probe.light.place);
    visit("light_view", probe.light.view);
    visit("light_projection", probe.light.projection);
    visit("light_color", probe.light.color);
    visit("ambient", probe.light.ambient);
}

inline void record_colors(Recorder& out, const std::vector<ShadowProbe>& probes, const gl::Program& shadows)
{
    record_single_points(out, "colors", "the second pass", probes, map_text,
                         [&](const std::vector<ShadowProbe>& asked) { return colors_of(asked, shadows); });
}

/// What of that the first pass uses.
struct FirstPassProbe {
    ShadowProbe probe;
};

template <class Visit>
void for_each_input(FirstPassProbe& asked, const Visit& visit)
{
    visit("position", asked.probe.place);
    visit("model", asked.probe.model);
    visit("light", asked.probe.light.place);
}

/// The first pass of single points: what the map would hold.
inline std::vector<float> distances_of(const std::vector<FirstPassProbe>& points, const gl::Program& distances)
{
    const auto size = static_cast<int>(points.size());
    const DistanceMap map(size, 1);
    map.begin();
    draw_single_points(size, [&](std::size_t i) {
        set_light(distances, points[i].probe.light);
        distances.set("light_projection", to_centre());
        feed_place(distances, points[i].probe);
    });
    return map.read().cells;
}

inline void record_distances(Recorder& out, const std::vector<ShadowProbe>& probes, const gl::Program& distances)
{
    std::vector<FirstPassProbe> points;
    for (const ShadowProbe& probe : probes) points.push_back({probe});
    record_single_points(
        out, "distances", "the first pass", points,
        [](const FirstPassProbe&) { return "// a point that lies here in the world:\n"; },
        [&](const std::vector<FirstPassProbe>& asked) { return distances_of(asked, distances); });
}

}
