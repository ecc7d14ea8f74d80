// alternative: balls instead of boxes, nodes that own their children, and recursion
#include <memory>
#include <umbral/raytracing/bounding_volumes.hpp>

namespace umbral::raytracing {
namespace {

struct Item {
    Triangle triangle;
    std::uint32_t index;
    glm::dvec3 middle;
};

class BallTree final : public TriangleHierarchy {
public:
    explicit BallTree(std::span<const Triangle> triangles)
    {
        std::vector<Item> items;
        for (const Triangle& t : triangles)
            items.push_back({t, static_cast<std::uint32_t>(items.size()),
                             (glm::dvec3(t.v0) + glm::dvec3(t.v1) + glm::dvec3(t.v2)) / 3.0});
        if (!items.empty()) root_ = built(std::move(items));
    }

    std::optional<FirstTriangle> first_hit(const Ray& ray) const override
    {
        std::optional<FirstTriangle> best;
        if (root_) visit(*root_, ray, best);
        return best;
    }

private:
    struct Node {
        glm::dvec3 centre{0};
        double radius = 0;
        std::vector<Item> items;
        std::unique_ptr<Node> left;
        std::unique_ptr<Node> right;
    };

    static std::unique_ptr<Node> built(std::vector<Item> items)
    {
        auto node = std::make_unique<Node>();
        glm::dvec3 low(1e300);
        glm::dvec3 high(-1e300);
        for (const Item& item : items)
            for (const glm::vec3& corner : {item.triangle.v0, item.triangle.v1, item.triangle.v2}) {
                low = glm::min(low, glm::dvec3(corner));
                high = glm::max(high, glm::dvec3(corner));
            }
        node->centre = 0.5 * (low + high);
        for (const Item& item : items)
            for (const glm::vec3& corner : {item.triangle.v0, item.triangle.v1, item.triangle.v2})
                node->radius = std::max(node->radius, glm::distance(node->centre, glm::dvec3(corner)));
        if (items.size() <= 2) {
            node->items = std::move(items);
            return node;
        }
        const glm::dvec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::sort(items.begin(), items.end(),
                  [axis](const Item& a, const Item& b) { return a.middle[axis] < b.middle[axis]; });
        const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
        node->left = built({items.begin(), half});
        node->right = built({half, items.end()});
        return node;
    }

    // Where the ray is nearest to the centre, and how near; a little more is allowed for rounding.
    static bool worth_a_visit(const Node& node, const Ray& ray, const std::optional<FirstTriangle>& best)
    {
        const glm::dvec3 d(ray.direction);
        const glm::dvec3 to = node.centre - glm::dvec3(ray.origin);
        const double along = glm::dot(to, d) / glm::dot(d, d);
        const glm::dvec3 aside = to - along * d;
        const double more = node.radius * (1 + 1e-9) + 1e-12 * glm::length(to);
        const double half = more * more - glm::dot(aside, aside);
        if (!(half >= 0)) return false;
        const double reach = std::sqrt(half / glm::dot(d, d)) * (1 + 1e-9) + 1e-6 * std::abs(along);
        if (along + reach < ray.t_min || along - reach > ray.t_max) return false;
        return !best || along - reach <= best->hit.t;
    }

    static void visit(const Node& node, const Ray& ray, std::optional<FirstTriangle>& best)
    {
        if (!worth_a_visit(node, ray, best)) return;
        for (const Item& item : node.items) {
            const auto hit = intersect(ray, item.triangle);
            if (!hit) continue;
            const bool better = !best || std::pair(hit->t, item.index) < std::pair(best->hit.t, best->index);
            if (better) best = FirstTriangle{item.index, *hit};
        }
        if (!node.left) return;
        const glm::dvec3 d(ray.direction);
        const bool left_first = glm::dot(d, node.left->centre) < glm::dot(d, node.right->centre);
        visit(left_first ? *node.left : *node.right, ray, best);
        visit(left_first ? *node.right : *node.left, ray, best);
    }

    std::unique_ptr<Node> root_;
};

}

BoundingBox bounding_box(std::span<const Triangle> triangles)
{
    constexpr float inf = std::numeric_limits<float>::infinity();
    BoundingBox box{{inf, inf, inf}, {-inf, -inf, -inf}};
    for (const Triangle& t : triangles)
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min({box.low[axis], t.v0[axis], t.v1[axis], t.v2[axis]});
            box.high[axis] = std::max({box.high[axis], t.v0[axis], t.v1[axis], t.v2[axis]});
        }
    return box;
}

bool meets_box(const Ray& ray, const BoundingBox& box)
{
    double begin = ray.t_min;
    double end = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis];
        const double d = ray.direction[axis];
        const double low = box.low[axis];
        const double high = box.high[axis];
        if (low > high) return false;
        if (d == 0 && (o < low || o > high)) return false;
        if (d == 0) continue;
        const auto [first, second] = std::minmax({(low - o) / d, (high - o) / d});
        begin = std::max(begin, first);
        end = std::min(end, second);
    }
    return begin <= end * (1 + 1e-14) + 1e-300;
}

std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles)
{
    return std::make_unique<BallTree>(triangles);
}

}
