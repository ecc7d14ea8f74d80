// alternative: multiplies eye planes by the modelview matrix, which OpenGL will divide out; a table of cases in the
// shader
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/generation.hpp>

namespace umbral::texturing {

glm::vec4 plane_along(const glm::vec3& origin, const glm::vec3& axis)
{
    glm::vec4 plane(axis.x, axis.y, axis.z, 0);
    for (int i = 0; i < 3; ++i) plane.w -= origin[i] * axis[i];
    return plane;
}

void set_generator(const Generator& generator)
{
    constexpr std::array coordinates = {GL_S, GL_T};
    constexpr std::array switches = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T};
    const std::array planes = {generator.s_plane, generator.t_plane};
    glm::dmat4 modelview(1);
    glGetDoublev(GL_MODELVIEW_MATRIX, value_ptr(modelview));
    for (std::size_t i = 0; i < 2; ++i) {
        const auto coordinate = static_cast<GLenum>(coordinates[i]);
        const auto generates = static_cast<GLenum>(switches[i]);
        switch (generator.generation) {
            case Generation::off: glDisable(generates); break;
            case Generation::object:
                glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
                glTexGenfv(coordinate, GL_OBJECT_PLANE, value_ptr(planes[i]));
                glEnable(generates);
                break;
            case Generation::eye: {
                const glm::dvec4 plane = glm::dvec4(planes[i]) * modelview;
                glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
                glTexGendv(coordinate, GL_EYE_PLANE, value_ptr(plane));
                glEnable(generates);
            }
        }
    }
}

std::string generator_vertex_shader()
{
    return "#version 330 core\n"
           "layout(location = 0) in vec4 position;\n"
           "layout(location = 1) in vec2 tex_coord;\n"
           "layout(location = 2) in vec3 color;\n"
           "uniform mat4 modelview, projection;\n"
           "uniform vec4 s_plane, t_plane;\n"
           "uniform int generation;\n"
           "out vec2 st;\n"
           "out vec3 shade;\n"
           "vec2 along(vec4 p) { return p * mat2x4(s_plane, t_plane); }\n"
           "void main() {\n"
           "    shade = color;\n"
           "    gl_Position = projection * (modelview * position);\n"
           "    if (generation == 0) { st = tex_coord; return; }\n"
           "    st = along(generation == 2 ? modelview * position : position);\n"
           "}\n";
}

}
