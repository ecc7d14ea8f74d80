// alternative: float, with boxes made larger; splits where the sum of areas times counts is least, in 8 bins; recursion
#include <array>
#include <umbral/raytracing/bounding_volumes.hpp>

namespace umbral::raytracing {
namespace {

struct Box {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void add(const Triangle& t)
    {
        add(t.v0);
        add(t.v1);
        add(t.v2);
    }
    void add(const Box& other)
    {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    float area() const
    {
        if (low.x > high.x) return 0;
        const glm::vec3 s = high - low;
        return s.x * s.y + s.y * s.z + s.z * s.x;
    }
};

// Where the ray enters, or nothing; everything is a few roundings wider than it is.
bool enters(const Ray& ray, const glm::vec3& low, const glm::vec3& high, float& at)
{
    float first = ray.t_min;
    float last = ray.t_max;
    for (int i = 0; i < 3; ++i) {
        const float o = ray.origin[i];
        const float d = ray.direction[i];
        if (d == 0.0F) {
            if (o < low[i] || o > high[i]) return false;
        } else {
            float a = (low[i] - o) / d;
            float b = (high[i] - o) / d;
            if (a > b) std::swap(a, b);
            a -= 4e-7F * std::abs(a);
            b += 4e-7F * std::abs(b);
            if (a > first) first = a;
            if (b < last) last = b;
        }
        if (first > last) return false;
    }
    at = first;
    return true;
}

struct BinNode {
    Box box;
    int left = -1;
    int right = -1;
    std::vector<std::uint32_t> own;
};

class BinTree final : public TriangleHierarchy {
public:
    explicit BinTree(std::span<const Triangle> list)
    {
        for (const Triangle& t : list) all_.push_back(t);
        std::vector<std::uint32_t> everything;
        for (std::uint32_t i = 0; i < all_.size(); ++i) everything.push_back(i);
        if (!all_.empty()) root_ = make(everything, 0);
    }

    std::optional<FirstTriangle> first_hit(const Ray& ray) const override
    {
        std::optional<FirstTriangle> best;
        float at = 0;
        if (root_ >= 0 && enters(ray, node(root_).box.low, node(root_).box.high, at)) walk(root_, ray, best);
        return best;
    }

private:
    const BinNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

    float centre(std::uint32_t i, int axis) const
    {
        const Triangle& t = all_[i];
        return 0.5F * std::min({t.v0[axis], t.v1[axis], t.v2[axis]}) +
               0.5F * std::max({t.v0[axis], t.v1[axis], t.v2[axis]});
    }

    int make(const std::vector<std::uint32_t>& list, int depth)
    {
        const int me = static_cast<int>(nodes_.size());
        nodes_.emplace_back();
        Box box;
        Box centres;
        for (const std::uint32_t i : list) {
            box.add(all_[i]);
            centres.add({centre(i, 0), centre(i, 1), centre(i, 2)});
        }
        const glm::vec3 more = 1e-6F * glm::max(glm::abs(box.low), glm::abs(box.high));
        nodes_[static_cast<std::size_t>(me)].box.low = box.low - more;
        nodes_[static_cast<std::size_t>(me)].box.high = box.high + more;
        std::vector<std::uint32_t> left;
        std::vector<std::uint32_t> right;
        if (list.size() > 3) divide(list, centres, depth, left, right);
        if (left.empty() || right.empty()) {
            nodes_[static_cast<std::size_t>(me)].own = list;
            return me;
        }
        const int l = make(left, depth + 1);
        const int r = make(right, depth + 1);
        nodes_[static_cast<std::size_t>(me)].left = l;
        nodes_[static_cast<std::size_t>(me)].right = r;
        return me;
    }

    void divide(const std::vector<std::uint32_t>& list, const Box& centres, int depth, std::vector<std::uint32_t>& left,
                std::vector<std::uint32_t>& right) const
    {
        const glm::vec3 spread = centres.high - centres.low;
        int axis = 0;
        if (spread[1] > spread[axis]) axis = 1;
        if (spread[2] > spread[axis]) axis = 2;
        constexpr int bins = 8;
        const auto bin_of = [&](std::uint32_t i) {
            const float place = (centre(i, axis) - centres.low[axis]) / spread[axis];
            return std::clamp(static_cast<int>(place * bins), 0, bins - 1);
        };
        int cut = 0;
        if (spread[axis] > 0 && depth < 40) {
            std::array<Box, bins> boxes;
            std::array<int, bins> counts{};
            for (const std::uint32_t i : list) {
                boxes[static_cast<std::size_t>(bin_of(i))].add(all_[i]);
                ++counts[static_cast<std::size_t>(bin_of(i))];
            }
            float least = std::numeric_limits<float>::infinity();
            for (int at = 1; at < bins; ++at) {
                Box a;
                Box b;
                int na = 0;
                int nb = 0;
                for (int i = 0; i < bins; ++i) {
                    (i < at ? a : b).add(boxes[static_cast<std::size_t>(i)]);
                    (i < at ? na : nb) += counts[static_cast<std::size_t>(i)];
                }
                const float price = a.area() * static_cast<float>(na) + b.area() * static_cast<float>(nb);
                if (na > 0 && nb > 0 && price < least) {
                    least = price;
                    cut = at;
                }
            }
        }
        for (std::size_t k = 0; k < list.size(); ++k) {
            const bool goes_left = cut > 0 ? bin_of(list[k]) < cut : 2 * k < list.size();
            (goes_left ? left : right).push_back(list[k]);
        }
    }

    void walk(int at, const Ray& ray, std::optional<FirstTriangle>& best) const
    {
        const BinNode& here = node(at);
        for (const std::uint32_t i : here.own) {
            const std::optional<TriangleHit> hit = intersect(ray, all_[i]);
            if (!hit.has_value()) continue;
            if (best && (hit->t > best->hit.t || (hit->t == best->hit.t && i > best->index))) continue;
            best = FirstTriangle{i, hit.value()};
        }
        if (here.left < 0) return;
        float a = 0;
        float b = 0;
        const bool meets_left = enters(ray, node(here.left).box.low, node(here.left).box.high, a);
        const bool meets_right = enters(ray, node(here.right).box.low, node(here.right).box.high, b);
        const auto go = [&](int child, float entry) {
            if (!best || entry <= best->hit.t) walk(child, ray, best);
        };
        if (meets_left && (!meets_right || a <= b)) {
            go(here.left, a);
            if (meets_right) go(here.right, b);
        } else if (meets_right) {
            go(here.right, b);
            if (meets_left) go(here.left, a);
        }
    }

    std::vector<Triangle> all_;
    std::vector<BinNode> nodes_;
    int root_ = -1;
};

}

BoundingBox bounding_box(std::span<const Triangle> triangles)
{
    if (triangles.empty()) {
        const float inf = std::numeric_limits<float>::infinity();
        return {glm::vec3(inf), glm::vec3(-inf)};
    }
    Box box;
    for (const Triangle& t : triangles) box.add(t);
    return {box.low, box.high};
}

bool meets_box(const Ray& ray, const BoundingBox& box)
{
    if (glm::any(glm::greaterThan(box.low, box.high))) return false;
    float at = 0;
    return enters(ray, box.low, box.high, at);
}

std::unique_ptr<TriangleHierarchy> make_triangle_hierarchy(std::span<const Triangle> triangles)
{
    return std::make_unique<BinTree>(triangles);
}

}
