#include <umbral/raytracing/whitted.hpp>

namespace umbral::raytracing::whitted {

glm::vec3 direct_light(const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                       const glm::vec3& l)
{
    // TODO: the ambient reflectance, plus the diffuse one times max(0, n·l), plus the specular one times the highlight,
    // which is 0 if n·l <= 0.
    return not_implemented<glm::vec3>(material, normal, v, l);
}

glm::vec3 light_towards(const World& world, const Hit& hit, const glm::vec3& v, int level)
{
    // TODO: turn the normal to the side of v; multiply reflectances by the texture's color. Begin with emission and
    // world.ambient(); add each light that is visible. Then, below the highest level, add what the surface mirrors and
    // what it lets through, by light_along with level + 1.
    return not_implemented<glm::vec3>(world, hit, v, level);
}

glm::vec3 light_along(const World& world, const Ray& ray, int level)
{
    // TODO: nothing above the highest level; else what the first hit sends back, or the background.
    return not_implemented<glm::vec3>(world, ray, level);
}

}
