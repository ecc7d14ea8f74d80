#include <umbral/raytracing/bounding_volumes.hpp>

namespace umbral::raytracing {

BoundingBox bounding_box(std::span<const Triangle> triangles)
{
    // TODO: the least and the greatest coordinate of all corners, in x, y and z.
    return not_implemented<BoundingBox>(triangles);
}

bool meets_box(const Ray& ray, const BoundingBox& box)
{
    // TODO: for each axis, between which t the ray lies between the two planes; the ray meets the box if all three
    // intervals and [t_min, t_max] have a t in common.
    return not_implemented<bool>(ray, box);
}

std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles)
{
    // TODO: write a class that derives from TriangleHierarchy: a tree whose leaves hold a few triangles, and whose
    // nodes a box of all that is below them. To ask, walk down from the root, and pass over what the ray does not meet.
    return not_implemented<std::unique_ptr<TriangleHierarchy>>(triangles);
}

}
