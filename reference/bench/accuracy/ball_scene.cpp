#include "ball_scene.hpp"

#include <umbral/meshes/builders.hpp>

namespace umbral::bench {

std::vector<raytracing::Triangle> ball_triangles(std::uint32_t slices)
{
    const meshes::IndexedMesh mesh = meshes::make_sphere(slices, slices / 2);
    std::vector<raytracing::Triangle> triangles;
    for (const glm::uvec3& corners : mesh.triangles)
        triangles.push_back({mesh.positions[corners.x], mesh.positions[corners.y], mesh.positions[corners.z]});
    return triangles;
}

std::vector<Ray> rays_at_ball(int count, Random& random)
{
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = 2.0F * random.unit_vector();
        rays.push_back({origin, normalize(0.5F * random.in_cube() - origin)});
    }
    return rays;
}

}
