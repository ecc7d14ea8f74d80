#include <kit/axial.hpp>
#include <kit/numbers_changed.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

void record_box(Recorder& out, const glm::vec3& direction, std::string_view value = "box")
{
    const BoxPlace place = ask<box_place>(out, direction);
    out.columns(value, "face (0: right; 1: left; 2: top; 3: bottom; 4: back; 5: front), u, v");
    out.append(value, glm::vec3(static_cast<int>(place.face), place.uv));
}

void record_directions(Recorder& out, BoxFace face, glm::vec2 uv)
{
    out.append("directions", ask<box_direction>(out, BoxPlace{face, uv}));
    out.append("directions", ask<panorama_direction>(out, uv));
    out.append("directions", ask<sphere_direction>(out, uv));
}

// Numbers that a hand can work out. Varied, vectors are turned exactly, or rise a little, and places are moved.
void by_hand(Variation& vary, Recorder& out)
{
    const auto risen = [&](const glm::vec3& direction) { return direction + glm::vec3(0, vary.near(0.0F, 0.4F), 0); };
    for (const glm::vec3& to_eye : {glm::vec3(0, 0, 1), {1, 0, 1}, {-3, 2, 0}, {0, -1, 0}, {2, 1, -2}})
        for (const glm::vec3& normal : {glm::vec3(0, 0, 1), {0, 1, 0}, {0.6F, 0, 0.8F}}) {
            const ExactMap map = vary.exact_map(0);
            out.append("mirror", ask<mirrored_direction>(out, map.place(to_eye), map.place(normal)));
        }
    for (const float sign : {1.0F, -1.0F})
        for (const glm::vec3& direction : {glm::vec3(4, 2, 1), {1, 4, 2}, {2, -1, 4}, {4, -1, -3}, {-1, 2, 4}})
            record_box(out, vary.exact_map().place(sign * direction));
    for (const glm::vec3& direction :
         {glm::vec3(0, 0, -1), {1, 0, 0}, {-2, 0, 0}, {1, 0, -1}, {0, 1, -1}, {0, -3, 3}, {-1, 0, 1}}) {
        if (direction.z <= 0 || direction.x != 0) out.append("panorama", ask<panorama_place>(out, risen(direction)));
    }
    for (const glm::vec3& direction :
         {glm::vec3(0, 0, 1), {1, 0, 0}, {0, -2, 0}, {3, 0, 4}, {0, 3, -4}, {-4, 0, -3}, {-1, 0, 0}, {0, 1, 1}})
        out.append("sphere", ask<sphere_place>(out, risen(direction)));
    for (int face = 0; face < 6; ++face)
        for (const glm::vec2 uv : {glm::vec2(0.5F, 0.5F), {0.75F, 0.5F}, {0.5F, 0.25F}, {0.25F, 0.875F}})
            record_directions(out, static_cast<BoxFace>(face), vary.near(uv, 0.03F));
}

// Directions whose largest coordinate is larger than the others by a thousandth at least, so that no rounding chooses.
glm::vec3 towards_a_face(Random& random)
{
    glm::vec3 direction(random.uniform(-0.999F, 0.999F), random.uniform(-0.999F, 0.999F), 0);
    direction.z = random.below(2) == 0 ? 1.0F : -1.0F;
    const std::uint32_t shift = random.below(3);
    if (shift == 1) direction = {direction.z, direction.x, direction.y};
    if (shift == 2) direction = {direction.y, direction.z, direction.x};
    return direction;
}

// At least a degree off the way back and the axis.
glm::vec3 off_the_seam(Random& random)
{
    const float longitude = random.uniform(-3.12F, 3.12F);
    const float latitude = random.uniform(-1.55F, 1.55F);
    return {std::sin(longitude) * std::cos(latitude), std::sin(latitude), -std::cos(longitude) * std::cos(latitude)};
}

// What random directions and places are not: 0 in a coordinate, or equal coordinates; a question that differs from the
// one before in one number or in its face only. Ties of the box are exact ones. Elsewhere nothing comes close to where
// an answer jumps or roundings grow: off the panorama's axis and the way back, off -z, off the rim of the ball's map.
void record_changed(Random& random, Recorder& out, int i)
{
    using Mirror = std::pair<glm::vec3, glm::vec3>;
    const glm::vec3 normal = i % 20 == 0 ? random.unit_vector() : axial_vector(random, i / 10 % 3);
    const Mirror mirror(2.0F * random.unit_vector(), normal);
    for (const auto& [v, n] : numbers_changed(random, mirror, 3, [&](const Mirror& m) { return m.second == normal; }))
        out.append("mirror", ask<mirrored_direction>(out, v, n));
    out.append("mirror", ask<mirrored_direction>(out, mirror.first, axial_vector(random, i / 10 % 3)));
    out.append("mirror", ask<mirrored_direction>(out, normal, normal));

    const auto is_clear = [](const glm::vec3& d) {
        const glm::vec3 size = abs(d);
        const float most = std::max({size.x, size.y, size.z});
        const auto leads = [&](float other) { return other == most || other < 0.999F * most; };
        return most > 0.05F && leads(size.x) && leads(size.y) && leads(size.z);
    };
    for (const glm::vec3& d : numbers_changed(random, 3.0F * towards_a_face(random), 3, is_clear)) record_box(out, d);

    const auto is_off_seam = [](const glm::vec3& d) {
        const float flat = length(glm::vec2(d.x, d.z));
        return flat > 0.03F * std::abs(d.y) && flat > 0.01F && (d.z < 0 || std::abs(d.x) > 0.03F * d.z);
    };
    for (const glm::vec3& d : numbers_changed(random, 2.0F * off_the_seam(random), 3, is_off_seam))
        out.append("panorama", ask<panorama_place>(out, d));

    const auto is_off_back = [](const glm::vec3& d) { return length(d) > 0.01F && d.z > -0.9F * length(d); };
    const glm::vec3 seen(glm::vec2(axial_vector(random, 2)), random.uniform(-1, 2));
    for (const glm::vec3& d : numbers_changed(random, seen, 3, is_off_back))
        out.append("sphere", ask<sphere_place>(out, d));

    const auto is_place = [](const glm::vec2& uv) {
        const glm::vec2 flat = 2.0F * uv - 1.0F;
        return uv.x <= 1 && uv.y <= 1 && std::abs(dot(flat, flat) - 1) > 0.002F;
    };
    for (const glm::vec2& uv : numbers_changed(random, glm::vec2(0.6F * random.uniform(), 0.5F), 2, is_place)) {
        const std::uint32_t face = random.below(6);
        record_directions(out, static_cast<BoxFace>(face), uv);
        out.append("directions", ask<box_direction>(out, BoxPlace{static_cast<BoxFace>((face + 1) % 6), uv}));
        out.append("directions", ask<sphere_direction>(out, -uv - 0.01F));
    }
}

void random_directions(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        if (i % 10 == 0) record_changed(random, out, i);
        const glm::vec3 to_eye = random.uniform(0.1F, 4) * random.unit_vector();
        out.append("mirror", ask<mirrored_direction>(out, to_eye, random.unit_vector()));
        record_box(out, random.uniform(0.2F, 5) * towards_a_face(random));
        out.append("panorama", ask<panorama_place>(out, random.uniform(0.2F, 5) * off_the_seam(random)));
        out.append("sphere", ask<sphere_place>(out, random.uniform(0.2F, 5) * random.unit_vector()));
        const auto face = static_cast<BoxFace>(random.below(6));
        const float u = random.uniform();
        record_directions(out, face, {u, random.uniform()});
    }
}

// Edges and corners of the box, from both sides of zero.
void ties(Random& random, Recorder& out)
{
    for (const float x : {-1.0F, 1.0F})
        for (const float y : {-1.0F, 1.0F}) {
            const float third = random.uniform(-0.9F, 0.9F);
            for (const glm::vec3& direction :
                 {glm::vec3(x, y, third), {x, third, y}, {third, x, y}, {x, y, x}, {x, y, -x}})
                record_box(out, direction);
        }
    // Close to an edge on either side, from 2^-19 to 2^-8 of the coordinates.
    for (int i = 0; i < 48; ++i) {
        const float lead = 1 + std::exp2(-static_cast<float>(8 + random.below(12)));
        const int axis = i % 3;
        glm::vec3 direction(0);
        direction[axis] = random.below(2) == 0 ? 1.0F : -1.0F;
        direction[(axis + 1) % 3] = random.below(2) == 0 ? 1.0F : -1.0F;
        direction[(axis + 2) % 3] = random.uniform(-0.9F, 0.9F);
        direction[(axis + static_cast<int>(random.below(2))) % 3] *= lead;
        record_box(out, direction, "beside");
    }
}

// Beside -z, at an angle of about `off`.
glm::vec3 almost_back(float off, float turned) { return {off * std::cos(turned), off * std::sin(turned), -1}; }

void edges(Variation& vary, Recorder& out)
{
    for (const float zero : {0.0F, -0.0F})
        for (const float other : {0.0F, -0.0F}) {
            for (const glm::vec3& direction : {glm::vec3(zero, other, 1),
                                               {zero, 1, 1},
                                               {zero, -2, 1},
                                               {zero, 1, other},
                                               {zero, -1, other},
                                               {zero, other, -1},
                                               {1, zero, other}})
                out.append("panorama", ask<panorama_place>(out, direction));
            for (const glm::vec3& direction :
                 {glm::vec3(zero, other, -1), {zero, other, -3}, {zero, other, 2}, {1, zero, other}, {zero, 1, other}})
                out.append("sphere", ask<sphere_place>(out, direction));
        }
    for (const float off : {1e-4F, 1e-3F, 4e-3F, 0.012F, 0.05F})
        for (const float turned : {0.0F, 1.2F, 2.9F, 4.0F})
            out.append("beside", ask<sphere_place>(out, almost_back(vary.scaled(off, 1.5F), vary.near(turned, 1.0F))));
    for (const float off : {-5e-5F, 5e-5F})
        for (const glm::vec3& direction : {glm::vec3(off, 0, -1), {0, off, -1}})
            out.append("beside", ask<sphere_place>(out, direction));
    for (const glm::vec2 uv : {glm::vec2(0, 0),
                               {1, 0},
                               {1, 0.5F},
                               {0, 0.5F},
                               {0.5F, 1},
                               {0.05F, 0.1F},
                               {0.99F, 0.8F},
                               {0.9F, 0.5F},
                               {0.5F, 0.3F},
                               {0.3F, 0.6F},
                               // Within the rim and without it, by less than a twenty-thousandth.
                               {1 - 0x1p-16F, 0.5F},
                               {0.5F, 0x1p-16F},
                               {0.8F, 0.900015F},
                               {0.099985F, 0.2F}})
        out.append("directions", ask<sphere_direction>(out, uv));
    for (const float u : {-0.75F, 1.25F, 2.5F, -1.0F})
        out.append("directions", ask<panorama_direction>(out, {u, 0.375F}));
}

// As far from the seam and the axis, and so small that no float of full precision is left: 2^-149 times whole numbers.
glm::vec3 subnormal(Random& random, const glm::vec3& direction)
{
    const auto most = static_cast<float>(1U << (12 + random.below(11)));
    return std::numeric_limits<float>::denorm_min() * glm::trunc(most * direction);
}

// Squares that overflow or vanish in float.
void extreme(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const float size = std::pow(10.0F, i % 2 == 0 ? random.uniform(22, 37) : random.uniform(-36, -24));
        const auto sized = [&](const glm::vec3& direction) {
            return i % 4 == 3 ? subnormal(random, direction) : size * direction;
        };
        out.append("panorama", ask<panorama_place>(out, sized(off_the_seam(random))));
        out.append("sphere", ask<sphere_place>(out, sized(random.unit_vector())));
        if (i % 2 == 0) {
            const float off = std::pow(10.0F, random.uniform(-7, -3));
            out.append("sphere", ask<sphere_place>(out, almost_back(off, random.uniform(0, 6.28F))));
        }
        record_box(out, i % 2 == 0 ? 3.2e38F * towards_a_face(random) : sized(towards_a_face(random)));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { random_directions(c.random, out); }},
    {"ties", [](Case& c, Recorder& out) { ties(c.random, out); }},
    {"edges", [](Case& c, Recorder& out) { edges(c.vary, out); }},
    {"extreme", [](Case& c, Recorder& out) { extreme(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(out, 440, 290, c.vary)); }},
};

}
