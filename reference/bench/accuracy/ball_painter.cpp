#include "ball_painter.hpp"

#include <umbral/gl/opengl.hpp>

namespace umbral::bench {
namespace {

constexpr const char* vertex_text = R"(#version 330
in vec3 position;
in vec3 normal;
uniform mat3 turn;
uniform float scale;
out vec3 eye_normal;
void main()
{
    eye_normal = turn * normal;
    gl_Position = vec4(scale * (turn * position), 1.0) * vec4(1.0, 1.0, -1.0, 1.0);
}
)";

constexpr const char* fragment_text = R"(#version 330
in vec3 eye_normal;
out vec4 color;
void main()
{
    vec3 n = normalize(eye_normal);
    vec3 light = normalize(vec3(-0.4, 0.6, 0.7));
    float diffuse = max(dot(n, light), 0.0);
    float specular = pow(max(dot(n, normalize(light + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
    color = vec4(vec3(0.08) + diffuse * vec3(0.75, 0.45, 0.2) + vec3(0.35 * specular), 1.0);
}
)";

/// Rows: what is right, up and towards the eye, in the ball's coordinates.
glm::mat3 turn_to_eye()
{
    const glm::dvec3 towards = BallPainter::towards_eye();
    const glm::dvec3 right = normalize(cross(glm::dvec3(0, 0, 1), towards));
    return glm::mat3(transpose(glm::dmat3(right, cross(towards, right), towards)));
}

}

BallPainter::BallPainter() : frame_(size, size), program_({"ball.vert", vertex_text}, {"ball.frag", fragment_text})
{
    program_.set("turn", turn_to_eye());
    program_.set("scale", static_cast<float>(2 * radius / size));
}

glm::dvec3 BallPainter::towards_eye() { return normalize(glm::dvec3(0.83, -0.31, 0.59)); }

void BallPainter::draw(const gl::Mesh& mesh) const
{
    frame_.clear({0, 0, 0, 1});
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    mesh.draw(program_);
    glFinish();
}

}
