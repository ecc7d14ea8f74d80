// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Compatibility Profile).
// 2017, section 12.1.3 (generating texture coordinates).

#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/generation.hpp>

namespace umbral::texturing {
namespace {

/// Has the modelview matrix be the identity while it lives.
class IdentityModelview {
public:
    IdentityModelview()
    {
        glGetIntegerv(GL_MATRIX_MODE, &mode_);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glLoadIdentity();
    }
    IdentityModelview(const IdentityModelview&) = delete;
    IdentityModelview& operator=(const IdentityModelview&) = delete;
    ~IdentityModelview()
    {
        glPopMatrix();
        glMatrixMode(static_cast<GLenum>(mode_));
    }

private:
    GLint mode_ = GL_MODELVIEW;
};

void generate(GLenum coordinate, GLint mode, GLenum name, const glm::vec4& plane)
{
    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
    glTexGenfv(coordinate, name, &plane.x);
}

}

glm::vec4 plane_along(const glm::vec3& origin, const glm::vec3& axis) { return {axis, -dot(origin, axis)}; }

void set_generator(const Generator& generator)
{
    if (generator.generation == Generation::off) {
        glDisable(GL_TEXTURE_GEN_S);
        glDisable(GL_TEXTURE_GEN_T);
        return;
    }
    if (generator.generation == Generation::object) {
        generate(GL_S, GL_OBJECT_LINEAR, GL_OBJECT_PLANE, generator.s_plane);
        generate(GL_T, GL_OBJECT_LINEAR, GL_OBJECT_PLANE, generator.t_plane);
    } else {
        // OpenGL multiplies eye planes by the inverse of the modelview matrix that it has now.
        const IdentityModelview identity;
        generate(GL_S, GL_EYE_LINEAR, GL_EYE_PLANE, generator.s_plane);
        generate(GL_T, GL_EYE_LINEAR, GL_EYE_PLANE, generator.t_plane);
    }
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
}

std::string generator_vertex_shader()
{
    return R"(#version 330
in vec4 position;
in vec2 tex_coord;
in vec3 color;
uniform mat4 modelview;
uniform mat4 projection;
uniform int generation; // 0: the vertex' own coordinates, 1: from object coordinates, 2: from eye coordinates
uniform vec4 s_plane;
uniform vec4 t_plane;
out vec2 st;
out vec3 shade;

void main()
{
    vec4 eye = modelview * position;
    vec4 from = generation == 1 ? position : eye;
    st = generation == 0 ? tex_coord : vec2(dot(s_plane, from), dot(t_plane, from));
    shade = color;
    gl_Position = projection * eye;
}
)";
}

}
