#pragma once

#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/program.hpp>

#include "ball_mesh.hpp"

namespace umbral::bench {

/// Draws balls in an orthographic view along -z of a turned ball, lit by one lamp. Needs a current context.
class BallPainter {
public:
    static constexpr int size = 512;
    static constexpr double radius = 230;  ///< of the sphere in the picture, in pixels

    BallPainter();

    /// The direction from the ball to the eye, in the ball's own coordinates: neither a pole nor the equator.
    [[nodiscard]] static glm::dvec3 towards_eye();

    /// Clears and draws one frame, and waits until it is there.
    void draw(const gl::Mesh& mesh) const;
    [[nodiscard]] Image picture() const { return frame_.read_pixels(); }

private:
    gl::Framebuffer frame_;
    gl::Program program_;
};

}
