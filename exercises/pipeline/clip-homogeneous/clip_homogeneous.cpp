#include <umbral/pipeline/clip.hpp>

namespace umbral::pipeline {

void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon)
{
    // TODO:
    // 1. Begin with the polygon of the three corners; their weights are (1, 0, 0), (0, 1, 0), (0, 0, 1).
    // 2. For each of the planes x = -w, x = w, y = -w, y = w, z = -w, z = w: walk round the polygon; keep the corners
    // inside, and add
    //    a new one where a side crosses the plane, with position and weights.
    // 3. Append what is left, if it is a polygon still. Do not divide by w anywhere: some corners lie behind the
    // camera.
    (void)not_implemented<int>(triangle, polygon);
}

}
