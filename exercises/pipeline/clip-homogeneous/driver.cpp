#include <bit>
#include <kit/magnitude.hpp>
#include <limits>
#include <map>
#include <umbral/record/driver.hpp>

#include "known_triangles.hpp"
#include "landscape.hpp"

namespace umbral {
namespace {

using namespace pipeline;

// Polygons are the same whatever corner they begin with. Recorded, they begin where a linear function is largest: in
// one corner only, unless a side happens to lie along its level lines. `value` gives what it is a function of.
template <class Value>
std::vector<ClipVertex> from_extreme(std::vector<ClipVertex> polygon, Value value)
{
    polygon.resize(std::min<std::size_t>(polygon.size(), 16));
    const auto less = [&](const ClipVertex& a, const ClipVertex& b) { return value(a) < value(b); };
    std::rotate(polygon.begin(), std::max_element(polygon.begin(), polygon.end(), less), polygon.end());
    return polygon;
}

double level(const glm::vec4& p)
{
    return 0.83 * double{p.x} + 0.61 * double{p.y} + 0.37 * double{p.z} + 0.19 * double{p.w};
}

std::vector<ClipVertex> by_position(const std::vector<ClipVertex>& polygon)
{
    return from_extreme(polygon, [](const ClipVertex& vertex) { return level(vertex.position); });
}

std::vector<ClipVertex> by_weights(const std::vector<ClipVertex>& polygon)
{
    return from_extreme(polygon, [](const ClipVertex& vertex) { return level(glm::vec4(vertex.weights, 0)); });
}

// Rows [triangle, corner, 0, numbers...].
template <std::size_t Count>
void append(Recorder& out, const char* name, std::size_t triangle, std::size_t corner,
            const std::array<float, Count>& numbers)
{
    std::array<float, Count + 3> row{static_cast<float>(triangle), static_cast<float>(corner), 0};
    std::copy(numbers.begin(), numbers.end(), row.begin() + 3);
    out.append(name, std::span<const float>(row));
}

/// Rows of these values are corners: `append` counts them behind the triangle.
void name_corners(Recorder& out, std::initializer_list<const char*> values)
{
    for (const char* const value : values) out.text(std::string(value) + ".names", "triangle: corner, -");
}

/// The same places, whatever all four coordinates are multiplied by.
ClipTriangle in_unit(const ClipTriangle& triangle, float unit)
{
    return {unit * triangle[0], unit * triangle[1], unit * triangle[2]};
}

/// A unit of clip coordinates. Homogeneous ones have none of their own, so it may be any: squares of these are no
/// floats.
float clip_unit(Random& random) { return random_unit(random, -90, 90); }

/// With `units`, each triangle is asked about in a unit of its own, and positions are recorded without it.
void record(Recorder& out, const std::vector<ClipTriangle>& triangles, Random* units = nullptr)
{
    name_corners(out, {"positions", "weights"});
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const float unit = units == nullptr ? 1 : clip_unit(*units);
        const std::vector<ClipVertex> polygon = clipped(out, in_unit(triangles[i], unit), i % 4 == 3);
        const std::vector<ClipVertex> positions = by_position(polygon);
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const glm::vec4 p = positions[k].position / unit;
            append(out, "positions", i, k, std::array{p.x, p.y, p.z, p.w});
        }
        const std::vector<ClipVertex> weights = by_weights(polygon);
        for (std::size_t k = 0; k < weights.size(); ++k)
            append(out, "weights", i, k, std::array{weights[k].weights.x, weights[k].weights.y, weights[k].weights.z});
    }
}

glm::vec4 random_corner(Random& random, float reach)
{
    const float w = std::exp2(random.uniform(-1, 2));
    return {reach * w * random.in_cube(), w};
}

/// Through all six sides of the volume: eight or nine corners are left.
ClipTriangle through_all_sides(Random& random)
{
    const int axis = static_cast<int>(random.below(3));
    ClipTriangle triangle{};
    for (int k = 0; k < 3; ++k) {
        const float w = std::exp2(random.uniform(-1, 2));
        const glm::vec3 place = glm::vec3(-1.87F, 1.83F, 0.05F) + 0.02F * random.in_cube();
        for (int i = 0; i < 3; ++i) triangle[static_cast<std::size_t>(k)][(axis + k + i) % 3] = w * place[i];
        triangle[static_cast<std::size_t>(k)].w = w;
    }
    if (random.below(2) == 0)
        for (glm::vec4& corner : triangle) corner.y = -corner.y;
    return triangle;
}

/// Something for which the whole triangle gives nothing.
void spoil(Random& random, glm::vec4& corner)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const int k = static_cast<int>(random.below(4));
    switch (random.below(4)) {
        case 0: corner[k] = std::numeric_limits<float>::quiet_NaN(); break;
        case 1: corner[k] = -infinity; break;
        case 2: corner[k] = infinity; break;
        default:
            for (int i = 0; i < 4; ++i) corner[i] = random.below(2) == 0 ? 0.0F : -0.0F;
    }
}

/// Smaller than a pixel, as hills far away are, without perspective every other time. Inside, or across one plane.
ClipTriangle small(Random& random)
{
    const float size = std::exp2(random.uniform(-17, -13));
    const bool cut = random.below(2) == 0;
    const bool perspective = random.below(2) == 0;
    const int axis = static_cast<int>(random.below(3));
    const std::size_t beyond = random.below(3);
    glm::vec3 middle = 0.8F * random.in_cube();
    if (cut) middle[axis] = middle[axis] < 0 ? -1 : 1;
    ClipTriangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
        glm::vec3 step = random.in_cube();
        if (cut) step[axis] = (k == beyond ? 1 : -1) * middle[axis] * random.uniform(0.3F, 1);
        triangle[k] = glm::vec4(middle + size * step, 1) * (perspective ? std::exp2(random.uniform(-1, 2)) : 1.0F);
    }
    return triangle;
}

std::vector<ClipTriangle> random_triangles(Random& random, int count)
{
    std::vector<ClipTriangle> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec4 a = random_corner(random, 1);
        const glm::vec4 b = random_corner(random, 2);
        triangles.push_back({a, b, random_corner(random, i % 3 == 0 ? 3.0F : 1.5F)});
        if (i % 12 == 5) triangles.back() = through_all_sides(random);
        if (i % 12 == 2 || i % 12 == 10) triangles.back() = small(random);
        if (i % 24 == 11) triangles.back() = {0.4F * a, 0.4F * a + 0.6F * glm::vec4(0, 0, 0, a.w), 0.4F * a};
        // A corner on a plane through the eye and two axes.
        if (i % 12 == 3) triangles.back()[static_cast<std::size_t>(i / 12 % 3)][i / 36 % 3] = 0;
        if (i % 12 == 8) spoil(random, triangles.back()[random.below(3)]);
        std::rotate(triangles.back().begin(), triangles.back().begin() + random.below(3), triangles.back().end());
    }
    return triangles;
}

// One corner before the camera, others behind it or, one time in four, exactly in its plane, there also on an axis.
std::vector<ClipTriangle> behind(Random& random, int count)
{
    std::vector<ClipTriangle> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec4 front = random_corner(random, i % 4 == 0 ? 1.5F : 0.9F);
        glm::vec3 far_side = 3.0F * random.in_cube();
        if (i % 8 == 1) far_side[static_cast<int>(random.below(3))] = 0;
        if (i % 16 == 1) far_side = {0, 0, far_side.z == 0 ? 1.0F : far_side.z};
        const glm::vec4 back(far_side, i % 4 == 1 ? 0 : random.uniform(-3, -0.1F));
        const glm::vec3 third = 3.0F * random.in_cube();
        triangles.push_back({front, back, glm::vec4(third, random.uniform(-3, 3))});
        std::rotate(triangles.back().begin(), triangles.back().begin() + random.below(3), triangles.back().end());
    }
    return triangles;
}

/// Round an edge of the volume: of three new corners one lies on it. Its other numbers are far from 1 and -1.
ClipTriangle round_an_edge(Random& random, int axis)
{
    const float side = random.below(2) == 0 ? 1 : -1;
    const float other_side = random.below(2) == 0 ? 1 : -1;
    const int other = (axis + 1) % 3;
    ClipTriangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
        const float w = std::exp2(random.uniform(-1, 2));
        triangle[k][axis] = side * w * (k == 1 ? random.uniform(2, 4) : random.uniform(0.1F, 0.3F));
        triangle[k][other] = other_side * w * (k == 2 ? random.uniform(2, 4) : random.uniform(0.1F, 0.3F));
        triangle[k][(axis + 2) % 3] = w * random.uniform(-0.5F, 0.5F);
        triangle[k].w = w;
    }
    return triangle;
}

/// Two corners before the camera and one behind it, so that one side passes the eye at a distance of 1e-6 to 1e-7: x
/// and w of the new corner are small differences. It crosses the plane x = w or x = -w.
ClipTriangle past_the_eye(Random& random)
{
    const float side = random.below(2) == 0 ? 1 : -1;
    const float size = random.uniform(0.5F, 1);
    const float past = size * (1 - std::exp2(random.uniform(-23, -20)));
    const float y = random.uniform(0.1F, 0.2F);
    return {glm::vec4(-side * size, 0, 0, size), {side * size, 0, 0, -past}, {0, y, random.uniform(0.1F, 0.2F), 1}};
}

// Triangles that cross one plane only. Along its axis each corner is recorded after the division: what was cut is at 1
// or -1, not beside it. Then some that cross two: along both axes.
void record_on_planes(Random& random, Recorder& out)
{
    name_corners(out, {"along"});
    for (std::size_t i = 0; i < 200; ++i) {
        const int axis = static_cast<int>(random.below(3));
        const float side = random.below(2) == 0 ? 1 : -1;
        ClipTriangle triangle = {random_corner(random, 0.9F), random_corner(random, 0.9F), random_corner(random, 0.9F)};
        const float beyond = side * random.uniform(1.1F, 4);
        triangle[random.below(3)][axis] = beyond * 4;
        const std::vector<ClipVertex> polygon = by_position(clipped(out, in_unit(triangle, clip_unit(random))));
        for (std::size_t k = 0; k < polygon.size(); ++k)
            append(out, "along", i, k, std::array{polygon[k].position[axis] / polygon[k].position.w});
    }
    for (std::size_t i = 200; i < 500; ++i) {
        const bool near_the_eye = i % 3 != 0;
        const int axis = near_the_eye ? 0 : static_cast<int>(i / 3 % 3);
        const std::vector<ClipVertex> polygon =
            by_position(clipped(out, near_the_eye ? past_the_eye(random) : round_an_edge(random, axis)));
        // On a plane or beside it; beside it other numbers may round otherwise.
        const auto along = [](const ClipVertex& vertex, int one) {
            const float ratio = vertex.position[one] / vertex.position.w;
            return std::abs(ratio) > 0.999F ? ratio : 0.0F;
        };
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            append(out, "along", 2 * i, k, std::array{along(polygon[k], axis)});
            if (!near_the_eye) append(out, "along", 2 * i + 1, k, std::array{along(polygon[k], (axis + 1) % 3)});
        }
    }
}

// Which corner of the whole mesh is the first with exactly these bits: triangles at one side refer to the same ones.
void record_seams(Variation& vary, Recorder& out)
{
    name_corners(out, {"first"});
    const Landscape land = hills(14, varied_ground(vary));
    std::map<std::array<std::uint32_t, 4>, std::array<float, 2>> first;
    for (std::size_t i = 0; i < land.triangles.size(); ++i) {
        const ClipTriangle triangle = land.projected(i);
        if ((outside_planes(triangle[0]) | outside_planes(triangle[1]) | outside_planes(triangle[2])) == 0) continue;
        const std::vector<ClipVertex> polygon = by_position(clipped(out, triangle));
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const glm::vec4 p = polygon[k].position + 0.0F;  // no -0
            const std::array bits = {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                                     std::bit_cast<std::uint32_t>(p.z), std::bit_cast<std::uint32_t>(p.w)};
            append(out, "first", i, k,
                   first.try_emplace(bits, std::array{static_cast<float>(i), static_cast<float>(k)}).first->second);
        }
    }
}

// A plain that reaches to the horizon, with one corner or two behind the camera: sides a million times as long as the
// near plane is far.
void record_plain(Random& random, Recorder& out)
{
    name_corners(out, {"ndc"});
    const glm::dmat4 projection(perspective(1.5F, 1, 1, 3e6F));
    for (std::size_t i = 0; i < 150; ++i) {
        ClipTriangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = std::exp2(double{random.uniform(0, 20)});
            const double x = size * double{random.uniform(-1, 1)};
            const double forward = k == 0   ? 1e6 * double{random.uniform(0.2F, 1)}
                                   : k == 1 ? -5 * double{random.uniform(0.1F, 1)}
                                            : size * double{random.uniform(-1, 1)};
            triangle[k] = glm::vec4(projection * glm::dvec4(x, -1 - 0.5 * double{random.uniform()}, -forward, 1));
        }
        const std::vector<ClipVertex> polygon = by_position(clipped(out, triangle));
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const glm::vec3 ndc = glm::vec3(polygon[k].position) / polygon[k].position.w;
            append(out, "ndc", i, k, std::array{ndc.x, ndc.y, ndc.z});
        }
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, by_hand()), c.vary.random()); }},
    {"on the border", [](Case& c, Recorder& out) { record(out, varied(c.vary, limits())); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_triangles(c.random, 300), &c.random); }},
    {"behind the camera", [](Case& c, Recorder& out) { record(out, behind(c.random, 200)); }},
    {"on the planes", [](Case& c, Recorder& out) { record_on_planes(c.random, out); }},
    {"seams", [](Case& c, Recorder& out) { record_seams(c.vary, out); }},
    {"plain", [](Case& c, Recorder& out) { record_plain(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_hills(out, c.vary)); }},
};

}
