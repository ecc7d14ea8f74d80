#pragma once

#include <umbral/transforms/pipeline.hpp>

namespace umbral::transforms {

/// The hook: the open line (0,0), (1,0), (1,1), (0,1), (0,2), in the current colour and width, from either end, in one
/// piece or several; neutral. Its lower end is (0,0), its upper end (0,2). Course: problem 2.15, gancho.
void draw_hook(Pipeline& pipeline);

/// Four copies of `hook` in a chain: each begins where the one before ended, turned by 90 degrees counter-clockwise
/// about that place. The first one is where it is; the four close a pinwheel, and the matrix is as it was. Calls only
/// `hook` and compose, with translations and rotations; no push, no pop. Course: problem 2.16, gancho_x4.
void draw_four_hooks(Pipeline& pipeline, const Figure& hook);

/// Draws `hook` once, turned, scaled alike in x and y, and moved, so that its lower end lies at `from` and its upper
/// end at `to`; never mirrored. What becomes of z, which is 0 all over a hook, does not matter. Neutral, for which it
/// may push and pop. Composes a translation, a rotation and a scaling, each by a call of its own; angles come from
/// trigonometric functions.
///
/// The points are homogeneous coordinates of the plane, (x, y, 1): the third number is w, not z. If they are the same
/// place, the hook shrinks to it: no number becomes NaN. Course: problem 2.17 (a), gancho_2p.
void draw_hook_between(Pipeline& pipeline, const Figure& hook, const glm::vec3& from, const glm::vec3& to);

/// The matrix that takes the hook's ends to these two points, as above, computed directly: no trigonometric function,
/// no square root. z is left alone.
///
/// Guarantee of the reference: every entry is rounded once, for all points whose distance float can hold. Course:
/// problem 2.17 (b).
[[nodiscard]] glm::mat4 hook_matrix(const glm::vec3& from, const glm::vec3& to);

/// `count` copies of `hook` round the circle of radius 1 about the origin. With p_i at the angle 2π i / count, copy i
/// goes from p_i to p_(i+1), for i = 0, 1, …, and the last one ends at p_0. Neutral; a count of 0 draws nothing.
/// Course: problem 2.18.
void draw_hook_circle(Pipeline& pipeline, const Figure& hook, unsigned count);

}
