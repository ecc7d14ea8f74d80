// Based on: T. Kay, J. Kajiya. Ray Tracing Complex Scenes. SIGGRAPH 1986 (slabs); and M. Pharr, W. Jakob, G. Humphreys.
// Physically Based Rendering. 4th edition, 2023, chapter 7.3 (a tree in an array, equal counts).

#include <algorithm>
#include <array>
#include <numeric>
#include <umbral/raytracing/bounding_volumes.hpp>

namespace umbral::raytracing {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr BoundingBox nothing{glm::vec3(infinity), glm::vec3(-infinity)};

BoundingBox with(const BoundingBox& box, const Triangle& triangle)
{
    return {min(box.low, min(triangle.v0, min(triangle.v1, triangle.v2))),
            max(box.high, max(triangle.v0, max(triangle.v1, triangle.v2)))};
}

/// The t in [t_min, t_max] at which the ray enters a box that is larger by `slack` on all sides.
std::optional<double> entry(const Ray& ray, const BoundingBox& box, double slack)
{
    double first = ray.t_min;
    double last = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        // From the origin to the two planes: differences of floats, which double has room for.
        const double to_low = double{box.low[axis]} - origin - slack;
        const double to_high = double{box.high[axis]} - origin + slack;
        if (direction == 0) {
            if (to_low > 0 || to_high < 0) return std::nullopt;
            continue;
        }
        first = std::max(first, (direction > 0 ? to_low : to_high) / direction);
        last = std::min(last, (direction > 0 ? to_high : to_low) / direction);
    }
    if (!(first <= last)) return std::nullopt;
    return first;
}

double largest_coordinate(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A node's triangles are a range of the order. Nodes lie in the order of a walk that takes the first half first: the
/// first child comes right behind its parent, and leaves have no second one.
struct Node {
    BoundingBox box;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t second = 0;
};

constexpr std::uint32_t most_in_leaf = 4;
constexpr std::size_t most_levels = 64;

class Tree final : public TriangleHierarchy {
public:
    explicit Tree(std::span<const Triangle> triangles) : triangles_(triangles.begin(), triangles.end())
    {
        order_.resize(triangles_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        const BoundingBox all = bounding_box(triangles_);
        reach_ = std::max(largest_coordinate(all.low), largest_coordinate(all.high));
        if (!order_.empty()) add(0, static_cast<std::uint32_t>(order_.size()));
    }

    [[nodiscard]] std::optional<FirstTriangle> first_hit(const Ray& ray) const override
    {
        std::optional<FirstTriangle> best;
        if (nodes_.empty()) return best;
        // intersect computes in double: what it takes for a hit lies in the box but for some of its roundings.
        const double slack = 1e-15 * (reach_ + largest_coordinate(ray.origin));
        struct Waiting {
            std::uint32_t node;
            double entry;
        };
        std::array<Waiting, most_levels> waiting;
        std::size_t count = 0;
        const auto put = [&](std::uint32_t node, const std::optional<double>& at) {
            if (at) waiting[count++] = {node, *at};
        };
        put(0, entry(ray, nodes_[0].box, slack));
        while (count > 0) {
            const auto [index, at] = waiting[--count];
            if (best && at > reached(*best)) continue;
            const Node& node = nodes_[index];
            if (node.second == 0) {
                for (std::uint32_t i = node.begin; i < node.end; ++i) take_nearer(best, ray, order_[i]);
                continue;
            }
            const auto first = entry(ray, nodes_[index + 1].box, slack);
            const auto second = entry(ray, nodes_[node.second].box, slack);
            // The nearer one on top, so that it is opened first.
            const bool second_is_nearer = first && second && *second < *first;
            put(second_is_nearer ? index + 1 : node.second, second_is_nearer ? first : second);
            put(second_is_nearer ? node.second : index + 1, second_is_nearer ? second : first);
        }
        return best;
    }

private:
    /// Nothing that begins beyond can be as near: t was rounded to float.
    static double reached(const FirstTriangle& best) { return std::nextafter(best.hit.t, infinity); }

    void take_nearer(std::optional<FirstTriangle>& best, const Ray& ray, std::uint32_t index) const
    {
        const std::optional<TriangleHit> hit = intersect(ray, triangles_[index]);
        if (!hit) return;
        if (!best || hit->t < best->hit.t || (hit->t == best->hit.t && index < best->index))
            best = FirstTriangle{index, *hit};
    }

    /// The triangles of a range in two halves of equal count, across the axis along which their middles spread most.
    /// So it ends in log n steps wherever they lie.
    void add(std::uint32_t begin, std::uint32_t end)
    {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({nothing, begin, end});
        glm::vec3 least(infinity);
        glm::vec3 greatest(-infinity);
        for (std::uint32_t i = begin; i < end; ++i) {
            nodes_[index].box = with(nodes_[index].box, triangles_[order_[i]]);
            least = min(least, middle(order_[i]));
            greatest = max(greatest, middle(order_[i]));
        }
        if (end - begin <= most_in_leaf) return;
        const glm::vec3 spread = greatest - least;
        const int axis = spread.x > spread.y ? (spread.x > spread.z ? 0 : 2) : (spread.y > spread.z ? 1 : 2);
        const std::uint32_t half = begin + (end - begin) / 2;
        std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                         [&](std::uint32_t a, std::uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
        add(begin, half);
        nodes_[index].second = static_cast<std::uint32_t>(nodes_.size());
        add(half, end);
    }

    [[nodiscard]] glm::vec3 middle(std::uint32_t index) const
    {
        const Triangle& triangle = triangles_[index];
        return triangle.v0 / 3.0F + triangle.v1 / 3.0F + triangle.v2 / 3.0F;
    }

    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    double reach_ = 0;
};

}

BoundingBox bounding_box(std::span<const Triangle> triangles)
{
    BoundingBox box = nothing;
    for (const Triangle& triangle : triangles) box = with(box, triangle);
    return box;
}

bool meets_box(const Ray& ray, const BoundingBox& box)
{
    if (box.low.x > box.high.x || box.low.y > box.high.y || box.low.z > box.high.z) return false;
    const double slack =
        1e-15 * (largest_coordinate(box.low) + largest_coordinate(box.high) + largest_coordinate(ray.origin));
    return entry(ray, box, slack).has_value();
}

std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles)
{
    return std::make_unique<Tree>(triangles);
}

}
