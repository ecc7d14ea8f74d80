#include <umbral/texturing/environment.hpp>

namespace umbral::texturing {

glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal)
{
    // TODO: keep the part of it along the normal, and turn the rest round.
    return not_implemented<glm::vec3>(to_eye, normal);
}

BoxPlace box_place(const glm::vec3& direction)
{
    // TODO: 1. which coordinate is the largest in absolute value, and what is its sign?
    //       2. the two others, divided by it, from -1 .. 1 to 0 .. 1
    return not_implemented<BoxPlace>(direction);
}

glm::vec3 box_direction(const BoxPlace& place)
{
    // TODO: the same table, read backwards.
    return not_implemented<glm::vec3>(place);
}

glm::vec2 panorama_place(const glm::vec3& direction)
{
    // TODO: longitude and latitude, each by atan2; mind -0, and straight up.
    return not_implemented<glm::vec2>(direction);
}

glm::vec3 panorama_direction(glm::vec2 uv)
{
    // TODO: from the angles back to a unit vector.
    return not_implemented<glm::vec3>(uv);
}

glm::vec2 sphere_place(const glm::vec3& direction)
{
    // TODO: the normal of the ball that mirrors +z there; for -z there are many.
    return not_implemented<glm::vec2>(direction);
}

glm::vec3 sphere_direction(glm::vec2 uv)
{
    // TODO: the ball's normal at that place, and what it mirrors.
    return not_implemented<glm::vec3>(uv);
}

}
