#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/transforms/frames.hpp>
#include <utility>

#include "../support.hpp"

/// Frames that the driver asks about.
namespace umbral::transforms {

/// Unit vectors, right-handed.
inline Frame cartesian(const glm::vec3& origin, Random& random)
{
    const AxisAngle turn = random_turn(random);
    const glm::mat4 m = glm::rotate(glm::mat4(1), turn.angle, turn.axis);
    return {glm::vec3(m[0]), glm::vec3(m[1]), glm::vec3(m[2]), origin};
}

/// Any lengths from 0.5 to 2, angles far from 0, either hand: a Cartesian frame whose vectors are scaled and lean by
/// less than half of it.
inline Frame oblique(const glm::vec3& origin, Random& random)
{
    Frame frame = cartesian(origin, random);
    for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z}) {
        const glm::vec3 lean = 0.25F * random.in_cube();
        *axis = random.uniform(0.5F, 2) * (*axis + lean);
    }
    if (random.below(2) == 1) frame.z = -frame.z;
    return frame;
}

inline glm::vec3& axis_of(Frame& frame, std::uint32_t axis)
{
    return axis == 0 ? frame.x : axis == 1 ? frame.y : frame.z;
}

/// A Cartesian frame but for one thing: one vector is longer or shorter, or the other way round, or leans; or all have
/// drifted a little.
inline Frame nearly_cartesian(const glm::vec3& origin, Random& random)
{
    Frame frame = cartesian(origin, random);
    const std::uint32_t one = random.below(3);
    glm::vec3& axis = axis_of(frame, one);
    switch (random.below(4)) {
        case 0: axis *= random.below(2) == 0 ? 1.5F : 0.75F; break;
        case 1: axis = -axis; break;
        case 2: axis += 0.3F * axis_of(frame, (one + 1) % 3); break;
        default: frame.x += 2e-3F * frame.y, frame.z *= 1.002F;
    }
    return frame;
}

/// Turned too often: each vector is off by this much in some direction. Of any hand.
inline Frame drifted(const glm::vec3& origin, float by, bool left_handed, Random& random)
{
    Frame frame = cartesian(origin, random);
    for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z}) *axis += by * random.unit_vector();
    if (left_handed) axis_of(frame, random.below(3)) *= -1.0F;
    return frame;
}

/// Turned about one of the world's axes, and all vectors of this length.
inline Frame level(const glm::vec3& origin, float size, Random& random)
{
    const auto axis = static_cast<int>(random.below(3));
    glm::vec3 about(0);
    about[axis] = 1;
    const glm::mat4 m = glm::rotate(glm::mat4(1), random.uniform(0.2F, 6), about);
    return {size * glm::vec3(m[0]), size * glm::vec3(m[1]), size * glm::vec3(m[2]), origin};
}

/// An origin for a frame whose vectors alone are asked about: 0, as one of the vectors, or anywhere.
inline glm::vec3 any_origin(Frame& frame, Random& random)
{
    const std::uint32_t axis = random.below(3);
    const glm::vec3 anywhere = 8.0F * random.in_cube();
    const std::uint32_t kind = random.below(3);
    return kind == 0 ? glm::vec3(0) : kind == 1 ? axis_of(frame, axis) : anywhere;
}

/// One vector longer, the next one shorter by the same factor: the volume stays.
inline void stretch(Frame& frame, std::uint32_t one, float factor)
{
    axis_of(frame, one) *= factor;
    axis_of(frame, (one + 1) % 3) /= factor;
}

/// A multiple of 2^-23 between 0.5 and 1 with all its digits, and a sign: the sum of two is a float, their products are
/// no doubles.
inline float full_number(Random& random)
{
    const float size = 0.5F + 0x1p-23F * static_cast<float>(random.below(1U << 22U));
    return random.below(2) == 0 ? size : -size;
}

/// Components j and k of x and y become such that x_j y_k - x_k y_j is 2^-46, the least that there is.
inline void make_nearly_parallel(Frame& frame, int j, int k)
{
    const float size = std::abs(frame.x[j]);
    frame.x[j] = size;
    frame.x[k] = size - 0x1p-23F;
    frame.y[j] = size + 0x1p-23F;
    frame.y[k] = size;
}

/// The same turned by a third of a turn about (1, 1, 1), or by none, and with the vectors in another such order.
inline void exchange_coordinates(Frame& frame, Random& random)
{
    const auto first = static_cast<int>(random.below(3));
    for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z})
        *axis = glm::vec3((*axis)[first], (*axis)[(first + 1) % 3], (*axis)[(first + 2) % 3]);
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        std::swap(frame.x, frame.y);
        std::swap(frame.y, frame.z);
    }
}

/// x and y as good as parallel, and z far from them: where all large products cancel, what remains is 2^-100 and less
/// of them, and may be 0.
inline Frame nearly_flat(bool flat, Random& random)
{
    const auto small = [&] { return std::ldexp(1.0F, -60 - static_cast<int>(random.below(60))); };
    const float p = full_number(random);
    const float q = full_number(random);
    const float step = small();
    const float s = flat ? p : full_number(random);
    const float t = flat ? q : full_number(random);
    Frame frame{{p, q, 0}, {p, q, small()}, {step * s, step * t, full_number(random)}, {0, 0, 0}};
    if (random.below(2) == 0) std::swap(frame.x, frame.z);
    exchange_coordinates(frame, random);
    return frame;
}

/// The largest two of the six products cancel exactly, 2^-80 … 2^-110 below them four others cancel but for 2^-66 of
/// their size, or exactly: what the small ones leave is lost if it is added to what the large ones rounded off.
inline Frame layered(bool flat, Random& random)
{
    Frame frame{};
    frame.x = {full_number(random), full_number(random), full_number(random)};
    frame.y = {full_number(random), full_number(random), full_number(random)};
    make_nearly_parallel(frame, 1, 2);
    if (flat) frame.x.y = frame.y.y, frame.x.z = frame.y.z;
    const int level = -80 - static_cast<int>(random.below(31));
    frame.x.y = std::ldexp(frame.x.y, level);
    frame.x.z = std::ldexp(frame.x.z, level);
    frame.z = frame.y;
    frame.z.x += random.below(2) == 0 ? 0x1p-23F : -0x1p-23F;
    if (random.below(2) == 0) std::swap(frame.y, frame.z);
    exchange_coordinates(frame, random);
    return frame;
}

}
