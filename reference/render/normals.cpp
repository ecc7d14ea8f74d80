#include "render/normals.hpp"

#include <algorithm>

namespace umbral::render {

DrawList normals_list(const DrawList& list, bool opposite)
{
    DrawList result = list;
    result.ambient = glm::vec3(0);
    result.lights.clear();
    for (int axis = 0; axis < 3; ++axis) {
        Light light{glm::vec4(0), glm::vec3(0)};
        light.where[axis] = opposite ? -1.0F : 1.0F;
        light.color[axis] = 1;
        result.lights.push_back(light);
    }
    for (Draw& draw : result.draws) {
        draw.material = scene::Material{};
        draw.specular = false;
        draw.texture.reset();
    }
    return result;
}

Grid<glm::vec3> normals_of(const Frame& positive, const Frame& negative)
{
    Grid<glm::vec3> normals(positive.width(), positive.height());
    std::transform(positive.color.cells.begin(), positive.color.cells.end(), negative.color.cells.begin(),
                   normals.cells.begin(),
                   [](const glm::vec4& a, const glm::vec4& b) { return glm::vec3(a) - glm::vec3(b); });
    return normals;
}

}
