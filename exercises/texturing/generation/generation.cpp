#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/generation.hpp>

namespace umbral::texturing {

glm::vec4 plane_along(const glm::vec3& origin, const glm::vec3& axis)
{
    // TODO: multiply out dot(axis, p - origin).
    return not_implemented<glm::vec4>(origin, axis);
}

void set_generator(const Generator& generator)
{
    // TODO: for S and for T: the mode, the plane, and whether they are generated at all. Mind the modelview matrix that
    // is there when you set eye planes.
    not_implemented<int>(generator);
}

std::string generator_vertex_shader()
{
    // TODO: the text of a vertex shader, as R"(#version 330 …)".
    return not_implemented<std::string>();
}

}
