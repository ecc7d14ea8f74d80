#include <glm/gtc/matrix_transform.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "bent_maps.hpp"
#include "changed_maps.hpp"
#include "measured_maps.hpp"

namespace umbral {
namespace {

using namespace transforms;

// Maps of the unit points and of others that a hand can find, and the defects of small parallelograms.
void record_known(Variation& vary, Recorder& out)
{
    const std::vector<glm::vec3> unit = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<glm::vec3> other = {{1, 1, 0}, {2, 1, 0}, {1, 3, 0}, {1, 1, -1}};
    const glm::dmat4 maps[] = {glm::dmat4(1),
                               glm::translate(glm::dmat4(1), {3, -2, 5}),
                               {{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {1, 2, 3, 1}},
                               {{2, 0, 0, 0}, {1, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 4, 1}},
                               {{1, 2, 3, 0}, {0, 1, 4, 0}, {5, 6, 0, 0}, {-1, 0, 1, 1}}};
    for (glm::dmat4 map : maps) {
        map[3] += glm::dvec4(by_quarters(vary, glm::vec3(0)), 0);
        record_matrix(out, pairs_of(unit, map));
        record_matrix(out, pairs_of(other, map));
    }
    const std::array<glm::vec3, 4> images[] = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
                                               {{{1, 2, 3}, {4, 2, 3}, {1, 0, 5}, {4, 0, 6}}},
                                               {{{2, 0, 1}, {0, 1, 0}, {5, 5, 5}, {1, -1, 2}}}};
    for (std::array<glm::vec3, 4> corners : images) {
        for (glm::vec3& corner : corners) corner = by_quarters(vary, corner);
        out.append("defect", ask<parallelogram_defect>(out, corners));
    }
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        const std::vector<glm::vec3> points = some_points(random, 0);
        record_matrix(out, pairs_of(points, sometimes_flattened(some_affine_map(random), random)));
        std::array<glm::vec3, 4> corners;
        for (glm::vec3& corner : corners) corner = 4.0F * random.in_cube();
        out.append("defect", ask<parallelogram_defect>(out, corners));
        if (i % 10 == 0) record_changed(random, out, corners);
        if (i % 8 == 0) record_other_pairs(random, out, points);
    }
}

// Five to twelve points, or far more, whose images are off by up to a tenth: which map misses them least? In every
// third set two points were measured twice, and so count twice.
void record_many(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        std::vector<glm::vec3> points = some_points(random, i % 4 == 3 ? many_more(random) : 1 + random.below(8));
        if (i % 3 == 1) points.insert(points.end(), {points[1], points[4]});
        record_matrix(out, noisy(pairs_of(points, some_affine_map(random)), 0.1F, random));
    }
}

// Whole numbers in a plane, a layer of 1e-11 of its width, one point four times, or less than four points, also none;
// paired with points in space. All of them are multiplied by a power of two, so that nothing rounds.
void record_planes(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        // Layers that are thicker than 1 among them.
        const float unit = std::ldexp(1.0F, static_cast<int>(random.below(80)) - 40) * (i % 16 == 10 ? 0x1p40F : 1.0F);
        const auto whole = [&] { return static_cast<float>(random.below(17)) - 8; };
        const float a = whole();
        const float b = whole();
        std::vector<glm::vec3> flat = {{0, 0, 0}, {3, 0, 3 * a}, {0, 2, 2 * b}};
        const std::size_t count = i % 8 == 0 ? 3 : 4 + random.below(4);
        while (flat.size() < count) {
            const float x = whole();
            const float y = whole();
            flat.emplace_back(x, y, a * x + b * y);
        }
        std::vector<glm::vec3> solid = flat;
        while (solid.size() < 4) solid.emplace_back(1, 1, 0);
        solid.back().z = a * solid.back().x + b * solid.back().y + 4;
        if (i % 8 == 1) flat.assign(4, flat.front());
        if (i % 8 == 0 && i < 24) flat.resize(static_cast<std::size_t>(i / 8));
        const bool flat_first = random.below(2) == 1;
        // Images may be of any size, or flat themselves: only the points count.
        const double size = std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
        const glm::dmat4 map = sometimes_flattened(scaled(some_affine_map(random), size), random);
        for (const bool is_flat : {flat_first, !flat_first}) {
            std::vector<glm::vec3> points = is_flat && i % 8 != 2 ? flat : solid;
            glm::vec3 thickness(1);
            if (i % 8 == 2 && is_flat) thickness[i / 8 % 3] = 0x1p-36F, thickness[(i / 8 + 1) % 3] = 16;
            // What is thin lies where its thickness is not rounded away.
            const glm::vec3 shift = i % 8 == 2 ? glm::vec3(0) : glm::vec3(16, -7, 5);
            for (glm::vec3& point : points) point = unit * (thickness * point + shift);
            out.append("found", ask<affine_from_points>(out, pairs_of(points, map)).has_value());
        }
    }
}

// Pairs of maps that bend by half of what is allowed and by twice as much: one image of nine, or of far more, moves
// away from the others. Images of all sizes, and of other extents in each coordinate. In every third pair the image
// moves in all three coordinates, each by nearly what is allowed, or one by more.
void record_affinity(Random& random, Recorder& out)
{
    for (int i = 0; i < 50; ++i) {
        const float size = std::pow(10.0F, random.uniform(-4, 4));
        const float tolerance = std::pow(10.0F, random.uniform(-3.7F, i % 3 == 0 ? -2.0F : -1.3F));
        Pairs pairs = pairs_of(some_points(random, i % 4 == 1 ? many_more(random) : 5), some_affine_map(random));
        glm::vec3 widths(1);
        widths[static_cast<int>(random.below(3))] = 0.1F;
        widths[static_cast<int>(random.below(3))] *= 0.2F;
        for (PointPair& pair : pairs) pair.image *= widths;
        const float extent = extent_of(pairs);
        const std::size_t moved = random.below(static_cast<std::uint32_t>(pairs.size()));
        const int axis = static_cast<int>(random.below(3));
        const bool bent_first = random.below(2) == 1;
        for (const bool is_bent : {bent_first, !bent_first}) {
            Pairs bent = pairs;
            const auto missed = static_cast<float>(missed_after_step(pairs, moved));
            for (int k = 0; k < 3; ++k) {
                const bool much = k == axis && is_bent;
                if (k != axis && i % 3 != 0) continue;
                const float share = much ? 2.0F : i % 3 == 0 ? 0.75F : 0.5F;
                bent[moved].image[k] += share * tolerance * extent / missed;
            }
            for (PointPair& pair : bent) pair.image *= size;
            out.append("affine", ask<is_affine>(out, bent, tolerance));
        }
    }
}

// Images anywhere, of which the nearest map misses a good part of their extent: as much as is allowed but for a
// twentieth, or more than that. The map's own images are not as far apart as those that were measured.
void record_scattered(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        glm::vec3 widths(0.5F);
        widths[static_cast<int>(random.below(3))] = 1;
        Pairs pairs;
        for (const glm::vec3& point : some_points(random, 1 + random.below(8)))
            pairs.push_back({point, widths * random.in_cube()});
        const auto share = static_cast<float>(missed_by_nearest(pairs)) / extent_of(pairs);
        const bool bent_first = random.below(2) == 1;
        for (const bool is_bent : {bent_first, !bent_first})
            out.append("affine", ask<is_affine>(out, pairs, (is_bent ? 0.95F : 1.05F) * share));
    }
}

// Points in a plane, or too few, for which there is no map, in pairs with points in space, all of which go to one
// place: a map that is affine, though its images have no extent.
void record_without_extent(Random& random, Recorder& out)
{
    for (const std::size_t count : {8U, 4U, 3U, 2U, 1U, 0U, 5U, 4U, 3U, 0U}) {
        Pairs solid;
        Pairs flat;
        for (const int k : {0, 1, 2, 4, 7, 3, 5, 6}) {
            const glm::vec3 corner(k & 1, k >> 1 & 1, k >> 2);
            solid.push_back({corner, {0.5F, -2, 1}});
            flat.push_back({{corner.x, corner.y, corner.x + corner.y}, corner});
        }
        solid.resize(std::max<std::size_t>(count, 4));
        flat.resize(count);
        const bool flat_first = random.below(2) == 1;
        for (const bool is_flat : {flat_first, !flat_first})
            out.append("affine", ask<is_affine>(out, is_flat ? flat : solid, 0.01F));
    }
}

// The course's example where the cosine comes out alike for all points, in pairs with places where it does not.
void record_wave(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        const bool alike_first = random.below(2) == 1;
        for (const bool is_alike : {alike_first, !alike_first}) {
            Pairs pairs;
            for (int k = 0; k < 9; ++k) {
                const double column = 0.25 * (k % 3) + (is_alike ? 0 : 0.11 * (k % 3 == 1 ? 1 : 0));
                const glm::dvec3 p(column, random.uniform_double(), k / 3 + random.uniform_double());
                pairs.push_back({glm::vec3(p), glm::vec3(course_wave(glm::dvec3(glm::vec3(p))))});
            }
            out.append("affine", ask<is_affine>(out, pairs, 0.01F));
        }
    }
}

// Points in a layer that is 1e-2 to 1e-6 of its width, turned anyhow: four, and more whose images are noisy.
void record_nearly_flat(Random& random, Recorder& out)
{
    for (const float thin : {1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        for (int i = 0; i < 12; ++i) {
            const AxisAngle turn = random_turn(random);
            const glm::mat3 turned(glm::rotate(glm::mat4(1), turn.angle, turn.axis));
            std::vector<glm::vec3> points = some_points(random, i % 2 == 0 ? 0 : 5);
            for (glm::vec3& point : points) point = turned * (point * glm::vec3(1, 1, thin));
            record_matrix(out,
                          noisy(pairs_of(points, some_affine_map(random)), i % 2 == 0 ? 0.0F : 0.1F * thin, random));
        }
    }
}

void record_all_sizes(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const float size = std::pow(10.0F, random.uniform(-6, 6));
        std::vector<glm::vec3> points = some_points(random, i % 2 == 0 ? 0 : 4);
        for (glm::vec3& point : points) point *= size;
        record_matrix(out, pairs_of(points, scaled(some_affine_map(random), std::pow(10, random.uniform(-6, 6)))));
    }
}

// A few steps wide, and as far from the origin as a country is wide in metres.
void record_far(Random& random, Recorder& out)
{
    for (const float far : {1e3F, 1e4F, 1e5F, 1e6F}) {
        for (int i = 0; i < 10; ++i) {
            const glm::vec3 here = far * random.unit_vector();
            std::vector<glm::vec3> points = some_points(random, i % 2 == 0 ? 0 : 4);
            for (glm::vec3& point : points) point = here + 4.0F * point;
            record_matrix(out, pairs_of(points, some_affine_map(random)));
        }
    }
}

// Points as far away, whose images lie near the origin: pairs of maps that bend by half of what is allowed and by twice
// as much. The matrix as it is returned, rounded to float, would miss these images.
void record_far_affinity(Random& random, Recorder& out)
{
    constexpr float tolerance = 1e-3F;
    for (const float far : {1e3F, 1e4F, 1e5F, 1e6F}) {
        for (int i = 0; i < 6; ++i) {
            const glm::vec3 here = far * random.unit_vector();
            std::vector<glm::vec3> points = some_points(random, 5);
            for (glm::vec3& point : points) point = here + 4.0F * point;
            const glm::dmat4 back = glm::translate(glm::dmat4(1), -glm::dvec3(here));
            const Pairs pairs = pairs_of(points, some_affine_map(random) * back);
            const std::size_t moved = random.below(9);
            const auto missed = static_cast<float>(missed_after_step(pairs, moved));
            const int axis = static_cast<int>(random.below(3));
            const bool bent_first = random.below(2) == 1;
            for (const bool is_bent : {bent_first, !bent_first}) {
                Pairs bent = pairs;
                bent[moved].image[axis] += (is_bent ? 2.0F : 0.5F) * tolerance * extent_of(pairs) / missed;
                out.append("affine", ask<is_affine>(out, bent, tolerance));
            }
        }
    }
}

// Images in whole steps, where a float counts no less: one that is a step off bends the map.
void record_whole_affinity(Random& random, Recorder& out)
{
    for (int i = 0; i < 16; ++i) {
        Pairs pairs = whole_and_far(random);
        const std::size_t moved = random.below(8);
        const float tolerance = 0.3F * static_cast<float>(missed_after_step(pairs, moved)) / extent_of(pairs);
        const int axis = static_cast<int>(random.below(3));
        const float unit = std::ldexp(1.0F, static_cast<int>(random.below(30)) - 24);
        const bool bent_first = random.below(2) == 1;
        for (const bool is_bent : {bent_first, !bent_first}) {
            Pairs bent = pairs;
            if (is_bent) bent[moved].image[axis] += 1;
            for (PointPair& pair : bent) pair.image *= unit;
            out.append("affine", ask<is_affine>(out, bent, tolerance));
        }
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"many", [](Case& c, Recorder& out) { record_many(c.random, out); }},
    {"planes", [](Case& c, Recorder& out) { record_planes(c.random, out); }},
    {"affinity",
     [](Case& c, Recorder& out) {
         record_affinity(c.random, out);
         record_scattered(c.random, out);
         record_without_extent(c.random, out);
     }},
    {"wave", [](Case& c, Recorder& out) { record_wave(c.random, out); }},
    {"nearly flat", [](Case& c, Recorder& out) { record_nearly_flat(c.random, out); }},
    {"all sizes", [](Case& c, Recorder& out) { record_all_sizes(c.random, out); }},
    {"far away",
     [](Case& c, Recorder& out) {
         record_far(c.random, out);
         record_far_affinity(c.random, out);
         record_whole_affinity(c.random, out);
         for (int i = 0; i < 40; ++i) out.append("defect", ask<parallelogram_defect>(out, cancelling_images(c.random)));
     }},
    {"picture", [](Case&, Recorder& out) { out.image("wave", draw_wave(out)); }},
};

}
