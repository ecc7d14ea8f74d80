#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "raytrace/hierarchy.hpp"

namespace umbral::raytrace {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t most_triangles = std::size_t{1} << 28U;
constexpr std::size_t bin_count = 16;
constexpr std::size_t most_in_leaf = 8;  ///< one packet

struct Box {
    glm::vec3 low{infinity};
    glm::vec3 high{-infinity};

    void add(const Box& other)
    {
        low = min(low, other.low);
        high = max(high, other.high);
    }
    void add(const glm::vec3& point)
    {
        low = min(low, point);
        high = max(high, point);
    }
    /// Half its surface; 0 of nothing.
    [[nodiscard]] float area() const
    {
        const glm::vec3 size = max(high - low, glm::vec3(0));
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

struct Item {
    Box box;
    glm::vec3 centre;
    std::uint32_t triangle;
};

struct Bin {
    Box box;
    std::size_t count = 0;
};

struct Split {
    int axis = -1;  ///< -1: there is none that is better than halves
    std::size_t bin = 0;
    float cost = infinity;
};

/// A part of the items and what surrounds it.
struct Part {
    std::size_t begin, end;
    Box box;

    [[nodiscard]] std::size_t count() const { return end - begin; }
};

std::size_t bin_of(float centre, float low, float scale)
{
    const float place = (centre - low) * scale;
    return place > 0 ? std::min(static_cast<std::size_t>(place), bin_count - 1) : 0;
}

/// Packets are what costs: nine triangles take two.
float packets(std::size_t count) { return static_cast<float>((count + lane_count - 1) / lane_count); }

Split best_of_axis(std::span<const Item> items, const Box& centres, int axis)
{
    Split best;
    const float extent = centres.high[axis] - centres.low[axis];
    const float scale = static_cast<float>(bin_count) / extent;
    if (!(extent > 0) || !(scale < infinity)) return best;
    std::array<Bin, bin_count> bins;
    for (const Item& item : items) {
        Bin& bin = bins[bin_of(item.centre[axis], centres.low[axis], scale)];
        bin.box.add(item.box);
        ++bin.count;
    }
    std::array<float, bin_count> right{};
    Bin all;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
        all.box.add(bins[i].box);
        all.count += bins[i].count;
        right[i] = all.box.area() * packets(all.count);
    }
    Bin left;
    for (std::size_t i = 1; i < bin_count; ++i) {
        left.box.add(bins[i - 1].box);
        left.count += bins[i - 1].count;
        const float cost = left.box.area() * packets(left.count) + right[i];
        if (left.count > 0 && left.count < items.size() && cost < best.cost) best = {axis, i, cost};
    }
    return best;
}

class Builder {
public:
    explicit Builder(std::span<const Corners> triangles) : triangles_(triangles)
    {
        items_.reserve(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            Item item{{}, {}, static_cast<std::uint32_t>(i)};
            for (const glm::vec3& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) item.box.add(corner);
            item.centre = 0.5F * item.box.low + 0.5F * item.box.high;
            items_.push_back(item);
        }
    }

    Hierarchy build()
    {
        if (!items_.empty()) {
            Part all{0, items_.size(), {}};
            for (const Item& item : items_) all.box.add(item.box);
            add_node({all});
        }
        return std::move(made_);
    }

private:
    /// Cuts a part in two, in place.
    std::array<Part, 2> cut(const Part& part)
    {
        const std::span<Item> items(items_.data() + part.begin, part.count());
        Box centres;
        for (const Item& item : items) centres.add(item.centre);
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = best_of_axis(items, centres, axis);
            if (split.cost < best.cost) best = split;
        }
        std::size_t middle = part.begin + part.count() / 2;
        if (best.axis >= 0) {
            const float low = centres.low[best.axis];
            const float scale = static_cast<float>(bin_count) / (centres.high[best.axis] - low);
            const auto second = std::partition(items.begin(), items.end(), [&](const Item& item) {
                return bin_of(item.centre[best.axis], low, scale) < best.bin;
            });
            middle = part.begin + static_cast<std::size_t>(second - items.begin());
        }
        std::array<Part, 2> halves{Part{part.begin, middle, {}}, Part{middle, part.end, {}}};
        for (Part& half : halves)
            for (std::size_t i = half.begin; i < half.end; ++i) half.box.add(items_[i].box);
        return halves;
    }

    /// Cuts the largest part again and again, until there are eight or all are leaves; adds a node of them.
    std::uint32_t add_node(std::vector<Part> parts)
    {
        while (parts.size() < lane_count) {
            const auto largest = std::max_element(parts.begin(), parts.end(),
                                                  [](const Part& a, const Part& b) { return weight(a) < weight(b); });
            if (weight(*largest) < 0) break;
            const std::array<Part, 2> halves = cut(*largest);
            *largest = halves[0];
            parts.push_back(halves[1]);
        }
        const auto place = static_cast<std::uint32_t>(made_.nodes.size());
        made_.nodes.emplace_back(empty_node());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Part& part = parts[i];
            const bool is_leaf = part.count() <= most_in_leaf;
            const std::uint32_t child = is_leaf ? add_packet(part) : add_node({part});
            Node& node = made_.nodes[place];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.bounds[2 * axis][i] = part.box.low[static_cast<int>(axis)];
                node.bounds[2 * axis + 1][i] = part.box.high[static_cast<int>(axis)];
            }
            node.child[i] = is_leaf ? leaf_bit | child : child;
        }
        return place;
    }

    /// Leaves are not cut.
    static float weight(const Part& part) { return part.count() > most_in_leaf ? part.box.area() : -1; }

    static Node empty_node()
    {
        Node node{};
        for (std::size_t i = 0; i < 6; ++i) fill(node.bounds[i], i % 2 == 0 ? infinity : -infinity);
        return node;
    }

    std::uint32_t add_packet(const Part& part)
    {
        Packet packet{};
        packet.triangle.fill(Hit::nothing);
        for (auto& corner : packet.corner)
            for (FloatLanes& axis : corner) fill(axis, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const std::size_t lane = i - part.begin;
            const Corners& corners = triangles_[items_[i].triangle];
            const std::array<glm::vec3, 3> points = {corners.a, corners.b, corners.c};
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    packet.corner[corner][axis][lane] = points[corner][static_cast<int>(axis)];
            packet.triangle[lane] = items_[i].triangle;
        }
        made_.packets.push_back(packet);
        return static_cast<std::uint32_t>(made_.packets.size() - 1);
    }

    std::span<const Corners> triangles_;
    std::vector<Item> items_;
    Hierarchy made_;
};

}

Hierarchy make_hierarchy(std::span<const Corners> triangles)
{
    if (triangles.size() > most_triangles)
        throw std::invalid_argument("make_hierarchy: expected at most " + std::to_string(most_triangles) +
                                    " triangles, got " + std::to_string(triangles.size()));
    return Builder(triangles).build();
}

}
