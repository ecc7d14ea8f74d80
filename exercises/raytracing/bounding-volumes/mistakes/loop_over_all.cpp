// mistake: no tree: a loop over all triangles
// credit: 40..75
// hint: Your answers are right, and take time in proportion to the number of triangles. Put boxes round groups of them,
// and boxes round those: what lies in a box that the ray does not meet need not be looked at.
#include <umbral/raytracing/bounding_volumes.hpp>

namespace umbral::raytracing {
namespace {

class List final : public TriangleHierarchy {
public:
    explicit List(std::span<const Triangle> triangles) : triangles_(triangles.begin(), triangles.end()) {}

    [[nodiscard]] std::optional<FirstTriangle> first_hit(const Ray& ray) const override
    {
        std::optional<FirstTriangle> best;
        for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            if (const auto hit = intersect(ray, triangles_[i]); hit && (!best || hit->t < best->hit.t))
                best = FirstTriangle{i, *hit};
        return best;
    }

private:
    std::vector<Triangle> triangles_;
};

}

BoundingBox bounding_box(std::span<const Triangle> triangles)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    BoundingBox box{glm::vec3(infinity), glm::vec3(-infinity)};
    for (const Triangle& triangle : triangles)
        for (const glm::vec3& corner : {triangle.v0, triangle.v1, triangle.v2}) {
            box.low = min(box.low, corner);
            box.high = max(box.high, corner);
        }
    return box;
}

bool meets_box(const Ray& ray, const BoundingBox& box)
{
    double first = ray.t_min;
    double last = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.low[axis] > box.high[axis]) return false;
        const double d = ray.direction[axis];
        double one = double{box.low[axis]} - double{ray.origin[axis]};
        double other = double{box.high[axis]} - double{ray.origin[axis]};
        if (d == 0) {
            if (one > 0 || other < 0) return false;
            continue;
        }
        one /= d;
        other /= d;
        first = std::max(first, std::min(one, other));
        last = std::min(last, std::max(one, other));
    }
    return first <= last;
}

std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles)
{
    return std::make_unique<List>(triangles);
}

}
