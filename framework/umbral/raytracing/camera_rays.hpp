#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>
#include <vector>

/// From pixels to rays. Places in a picture are counted in pixels from its upper left corner, x to the right and y
/// down: pixel (x, y) covers x to x + 1 and y to y + 1, and its centre is (x + 1/2, y + 1/2).
namespace umbral::raytracing {

/// A camera at `eye` that looks at `target` in perspective, so that `up` appears vertical. `up` has a length from 1e-12
/// to 1e12, and any angle with the view but 0 and 180 degrees; eye and target differ.
struct PrimaryCamera {
    glm::vec3 eye{0};
    glm::vec3 target{0, 0, -1};
    glm::vec3 up{0, 1, 0};
    float fovy = 1;  ///< vertical field of view in radians: the angle between the upper and the lower edge, 0 to 3
};

/// The ray from the camera's eye through a place of its picture of `width` x `height` pixels, both 1 or more. Pixels
/// are square. The direction has length one, and the ray begins at the eye and has no end.
///
/// `place` may lie outside the picture. Guarantee of the reference, with eyes up to 1e6 from the world's origin and
/// `up` at an angle of 0.001 or more with the view: every coordinate of the direction within 1e-7. Course: section D
/// 1G, "rayo primario"; problem 4.3.
[[nodiscard]] Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place);

/// The centres of the n x n equal squares that pixel (x, y) consists of, row by row, the upper left one first; n is 1
/// or more. For n = 1 it is the pixel's centre. Guarantee of the reference: within 1 ulp.
[[nodiscard]] std::vector<glm::vec2> pixel_samples(int x, int y, int n);

/// The light that comes back along a ray, linear, at least 0, without an upper bound.
using LightAlongRay = std::function<glm::vec3(const Ray&)>;

/// The picture that the camera takes: the colour of each pixel is the mean of the light along the rays through its n x
/// n samples. Linear light, neither clamped nor encoded. Each ray's light is asked for once, in any order.
///
/// Guarantee of the reference: within 1e-6 of the mean, relative. Course: section D 1G, "procedimiento principal de
/// Ray-Tracing".
[[nodiscard]] Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                                             const LightAlongRay& light_along);

}
