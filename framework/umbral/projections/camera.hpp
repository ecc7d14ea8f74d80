#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// What a camera is activated in: a pipeline with a view matrix and a projection matrix. Behind it may be OpenGL's
/// fixed function or a program with uniforms; a camera cannot tell. Course: Cauce.
class MatrixTarget {
public:
    virtual ~MatrixTarget() = default;

    /// From now on world coordinates go to camera coordinates by this matrix (fijarMatrizVista).
    virtual void set_view(const glm::mat4& view) = 0;
    /// From now on camera coordinates go to OpenGL's clip coordinates by this matrix (fijarMatrizProyeccion).
    virtual void set_projection(const glm::mat4& projection) = 0;
};

/// A camera: what its matrices depend on, and the matrices. Course: class Camara.
class Camera {
public:
    virtual ~Camera() = default;

    /// The picture's size in pixels from now on; before the first call it is square. Nothing may look deformed: a
    /// picture twice as wide as it is high shows twice as much across as upwards. Sizes of which one is not positive,
    /// as of a minimised window, are ignored. Course: fijarRatioViewport (height over width there).
    virtual void set_viewport(int width, int height) = 0;

    /// Sets both matrices of the target, each once, as they are for the camera's state of this moment. Every time: the
    /// target may be another one, or another camera may have been active in between. Course: activar.
    virtual void activate(MatrixTarget& target) = 0;
};

/// The course's base camera: orthographic, at the world's origin, without a turn. It sees x from -1 to 1 and, in a
/// picture of w x h pixels, y from -h/w to h/w; what lies at z = 1 is nearest to the viewer (depth -1), what lies at
/// z = -1 is farthest (depth 1).
///
/// Guarantee of the reference, here and below: every entry is the exact one rounded to float once, but for 1e-9 of the
/// largest of its column.
[[nodiscard]] std::unique_ptr<Camera> make_camera();

/// A camera that looks at the world's origin in perspective, and may turn about it in all directions, over the poles
/// too. Course: CamaraOrbitalSimple.
///
/// It stands at distance (cos b sin a, sin b, cos b cos a). The scene is turned by -a about the world's y axis, then by
/// b about the camera's x axis, then moved by -distance along z: so between b = 90 and 270 degrees the world's y axis
/// points down in the picture. The vertical field of view is 60 degrees; the near plane lies at 0.05, the far one at
/// 1000.05.
class OrbitalCamera : public Camera {
public:
    /// Both angles, in degrees, of any size. Throws std::invalid_argument if one is infinite or NaN; then nothing
    /// changes.
    virtual void set_angles(float a_degrees, float b_degrees) = 0;

    /// From the origin, more than 0. Throws std::invalid_argument if it is not, or is infinite or NaN; then nothing
    /// changes.
    virtual void set_distance(float distance) = 0;
};

/// A new camera, with the same ranges as above, and a square picture. Cameras share nothing.
[[nodiscard]] std::unique_ptr<OrbitalCamera> make_orbital_camera(float a_degrees, float b_degrees, float distance);

}
