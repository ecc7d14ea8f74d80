#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::raytracing {

/// A flat convex polygon in space: three corners or more in one plane, counter-clockwise as seen from its front.
/// Three of them may lie on a line. With fewer than three it is none: it throws and receives no shadow, and mirrors
/// nothing.
using FlatPolygon = std::vector<glm::vec3>;

/// The shadow that `caster` throws on `receiver`: the points of the receiver from which the segment to the light meets
/// the caster. Its corners lie in the receiver's plane and turn as the receiver's do; with which one it begins does not
/// matter, no corner comes twice in a row, and one that lies on a line between its neighbours may be left out.
///
/// `light` is (x, y, z, 1), a lamp at that place, or (x, y, z, 0), a sun in that direction, of any length. Both sides
/// of a polygon stop light and take shadows: that of the receiver on which the light stands has the shadow. Only what
/// lies between the light and the receiver throws one: casters may reach through the receiver's plane, behind it, past
/// the light's height, or behind the light. The lamp touches no caster. Nothing comes of a caster in the receiver's
/// plane or in one plane with the light, of a light in the receiver's plane, nor where caster and shadow have no more
/// than a side or a corner in common with the receiver. Guarantee of the reference: corners are within four ulp of the
/// largest coordinate, as long as the shadow's sides and what throws it are at least 1e-3 times as large. Course:
/// brute-force algorithm for cast shadows.
[[nodiscard]] FlatPolygon shadow_polygon(const glm::vec4& light, const FlatPolygon& caster,
                                         const FlatPolygon& receiver);

/// The matrix that takes each point to its mirror image in the plane n·p + w = 0, with n = plane.xyz of any length but
/// 0 and w = plane.w, at most 1e18 from the origin. Course: reflection in planar mirrors.
[[nodiscard]] glm::mat4 mirror_matrix(const glm::vec4& plane);

/// The view matrix of the camera that is symmetric to the one of `view`: what it sees at a place of the picture is what
/// `view` sees there in the mirror. Course: a camera symmetric to the original one.
[[nodiscard]] glm::mat4 mirrored_view(const glm::mat4& view, const glm::vec4& plane);

/// What is seen by way of one or more mirrors.
struct MirrorView {
    std::vector<std::size_t> path;  ///< the mirrors, as places in the list, in the order in which looks meet them
    glm::vec3 eye{0};               ///< where the eye seems to be, mirrored in each of them in that order
    FlatPolygon window;             ///< the part of the last mirror that is seen this way
};

/// All ways to look from `eye` by way of at most `levels` mirrors into which something is seen, each after the one that
/// it goes on from, and ways that go on from the same one by the order of their last mirror: depth first. None for
/// levels of 0 or less.
///
/// A mirror shows something on its front only, to an eye that stands before its plane, not in it. So for the first
/// mirror of a path the window is all of it. From there the mirrored eye looks through the window: the window of the
/// next mirror is its part that lies before the last one's plane and within the rays from that eye through the last
/// one's window; if nothing is left of it, or if that eye does not stand before it, the path ends. Mirrors do not hide
/// each other. Windows turn as their mirrors do. Guarantee of the reference: as of shadow_polygon.
[[nodiscard]] std::vector<MirrorView> mirror_views(const glm::vec3& eye, const std::vector<FlatPolygon>& mirrors,
                                                   int levels);

}
