#include <cmath>
#include <umbral/meshes/area.hpp>

#include "wide.hpp"

// Cross products and sums with 113 bits, rounded to float once. Lengths are roots with 64 bits or more: sums of squares
// cancel nothing.

namespace umbral::meshes {
namespace {

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Of the corners in another order than the reference's.
Wide wide_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    if (!finite(a) || !finite(b) || !finite(c)) return 0;
    Wide u[3];
    Wide v[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = Wide(a[i]) - Wide(c[i]);
        v[i] = Wide(b[i]) - Wide(c[i]);
    }
    long double square = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const auto component = static_cast<long double>(u[i] * v[j] - u[j] * v[i]);
        square += component * component;
    }
    return std::sqrt(square) / 2;
}

}

float triangle_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return static_cast<float>(wide_area(a, b, c));
}

float surface_area(const IndexedMesh& mesh)
{
    Wide sum = 0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += wide_area(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    return static_cast<float>(sum);
}

}
