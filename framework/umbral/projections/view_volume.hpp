#pragma once

namespace umbral::projections {

/// What a camera sees of its own coordinates: what lies between the planes z = -near_plane and z = -far_plane, and
/// between four sides. Course: l, r, b, t, n, f.
///
/// `left`, `right` bound x, `bottom`, `top` bound y: everywhere in an orthographic projection; in perspective where the
/// side planes, which all go through the eye, cut the plane z = -near_plane.
struct ViewVolume {
    float left;
    float right;
    float bottom;
    float top;
    float near_plane;
    float far_plane;
};

}
