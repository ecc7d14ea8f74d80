#pragma once

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/transforms/scene_graph.hpp>
#include <vector>

/// Scene graphs to expand and to convert.
namespace umbral::transforms {

/// A scene graph that grows: each function gives the place of what it adds.
class GraphBuilder {
public:
    std::uint32_t add_node(std::vector<Entry> entries)
    {
        graph.nodes.push_back(std::move(entries));
        return static_cast<std::uint32_t>(graph.nodes.size() - 1);
    }
    Entry move(float x, float y) { return add(glm::translate(glm::mat4(1), {x, y, 0})); }
    Entry scale(float x, float y) { return add(glm::scale(glm::mat4(1), {x, y, 1})); }
    Entry add(const glm::mat4& matrix)
    {
        graph.transformations.push_back(matrix);
        return {Entry::Kind::transformation, static_cast<std::uint32_t>(graph.transformations.size() - 1)};
    }

    SceneGraph graph;
};

inline Entry object(std::uint32_t name) { return {Entry::Kind::object, name}; }
inline Entry node(std::uint32_t place) { return {Entry::Kind::node, place}; }

/// The simple objects of the facade.
enum FacadeObject : std::uint32_t { square, triangle, circle, house };

/// Adds the course's facade, with its misprints put right, and gives its node.
inline std::uint32_t add_facade(GraphBuilder& b)
{
    const std::uint32_t left_frame = b.add_node({object(square), b.move(0, 1), b.scale(0.9F, -0.8F), object(triangle)});
    const std::uint32_t frames =
        b.add_node({b.scale(0.8F, 1), node(left_frame), b.move(2.4F, 0), b.scale(-1, 1), node(left_frame)});
    const std::uint32_t window = b.add_node({object(square), b.move(0.1F, 0.1F), b.scale(0.4F, 0.8F), node(frames)});
    const std::uint32_t small_window = b.add_node({b.scale(0.3F, 0.3F), node(window)});
    const std::uint32_t knob = b.add_node({b.move(0.1F, 0.5F), b.scale(0.06F, 0.06F), object(circle)});
    const std::uint32_t leaf = b.add_node({b.move(0.5F, 0), node(knob), b.scale(0.5F, 1), object(square)});
    const std::uint32_t door = b.add_node({node(leaf), b.move(1, 0), b.scale(-1, 1), node(leaf)});
    const std::uint32_t small_door = b.add_node({b.move(0.56F, 0), b.scale(0.3F, 0.43F), node(door)});
    return b.add_node({object(house), node(small_door), b.move(0.13F, 0.13F), node(small_window), b.move(0, 0.43F),
                       node(small_window), b.move(0.43F, 0), node(small_window)});
}

inline SceneGraph facade()
{
    GraphBuilder b;
    b.graph.root = add_facade(b);
    return b.graph;
}

/// A matrix that moves, turns and stretches a little.
inline glm::mat4 random_part(Random& random)
{
    const glm::mat4 moved = glm::translate(glm::mat4(1), 2.0F * random.in_cube());
    const glm::mat4 turned = glm::rotate(moved, random.uniform(-3, 3), random.unit_vector());
    return glm::scale(turned, {random.uniform(0.6F, 1.4F), random.uniform(0.6F, 1.4F), random.uniform(0.6F, 1.4F)});
}

/// Numbers 0 … count - 1 in random order.
inline std::vector<std::uint32_t> shuffled(std::uint32_t count, Random& random)
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < count; ++i) order.insert(order.begin() + random.below(i + 1), i);
    return order;
}

/// Up to seven nodes with shared parts: each contains up to two of those after it, between objects and transformations;
/// numbered anyhow.
inline SceneGraph random_graph(Random& random)
{
    const std::uint32_t count = 3 + random.below(5);
    const std::vector<std::uint32_t> place = shuffled(count, random);
    SceneGraph graph;
    for (int i = 0; i < 6; ++i) graph.transformations.push_back(random_part(random));
    graph.nodes.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<Entry>& entries = graph.nodes[place[i]];
        for (int part = 0; part < 3; ++part) {
            if (random.below(3) > 0) entries.push_back({Entry::Kind::transformation, random.below(6)});
            const std::uint32_t name = random.below(9);
            const std::uint32_t later = i + 1 + random.below(std::max(1U, count - i - 1));
            if (part < 2 && later < count)
                entries.push_back(node(place[later]));
            else
                entries.push_back(object(name));
        }
        if (random.below(2) == 0) entries.push_back({Entry::Kind::transformation, random.below(6)});
    }
    graph.root = place[0];
    return graph;
}

/// A chain of nodes, each with objects and a shared part beside the next one; some nodes contain a later one as well.
/// With `cycle`, one node of the chain contains an earlier one, or itself; no shortcut begins between the two, so that
/// there is no other cycle. One chain in three has no objects at all. A cycle that the root does not reach may be there
/// in any case.
inline SceneGraph random_chain(Random& random, bool cycle)
{
    const std::uint32_t length = 2 + random.below(5);
    const std::uint32_t count = length + 3;
    const std::vector<std::uint32_t> place = shuffled(count, random);
    const std::uint32_t shared = place[length];
    SceneGraph graph;
    graph.transformations = {random_part(random), random_part(random)};
    graph.nodes.resize(count);
    graph.root = place[0];
    graph.nodes[shared] = {object(7), {Entry::Kind::transformation, 0}, object(8)};
    for (std::uint32_t i = 0; i < length; ++i) {
        std::vector<Entry>& entries = graph.nodes[place[i]];
        entries = {node(shared), object(i), {Entry::Kind::transformation, 1}};
        if (i + 1 < length) entries.push_back(node(place[i + 1]));
        entries.push_back(node(shared));
    }
    const std::uint32_t last = random.below(length);
    const std::uint32_t first = random.below(last + 1);
    if (cycle) graph.nodes[place[last]].insert(graph.nodes[place[last]].begin() + random.below(3), node(place[first]));
    for (std::uint32_t i = 0; i < first; ++i)
        if (random.below(3) == 0) {
            const std::uint32_t later = i + 1 + random.below(last - i);
            std::vector<Entry>& entries = graph.nodes[place[i]];
            entries.insert(entries.begin() + random.below(static_cast<std::uint32_t>(entries.size())),
                           node(place[later]));
        }
    if (random.below(3) == 0)
        for (std::vector<Entry>& entries : graph.nodes)
            std::erase_if(entries, [](const Entry& entry) { return entry.kind == Entry::Kind::object; });
    const bool aside = random.below(2) == 0;
    if (aside) {
        graph.nodes[place[length + 1]] = {node(place[length + 2])};
        graph.nodes[place[length + 2]] = {object(3), node(place[length + 1])};
    }
    return graph;
}

/// The nodes that the root leads to.
inline std::vector<std::uint32_t> reached(const SceneGraph& graph)
{
    std::vector<std::uint32_t> all{graph.root};
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Entry& entry : graph.nodes[all[i]])
            if (entry.kind == Entry::Kind::node && std::ranges::find(all, entry.index) == all.end())
                all.push_back(entry.index);
    return all;
}

/// `levels` nodes, each of which contains the next one twice; what is in the last one is there 2^(levels - 1) times.
inline SceneGraph doubling(std::uint32_t levels, std::vector<Entry> last)
{
    SceneGraph graph{{glm::translate(glm::mat4(1), {1, 0, 0})}, {}, 0};
    for (std::uint32_t i = 1; i < levels; ++i)
        graph.nodes.push_back({node(i), {Entry::Kind::transformation, 0}, node(i)});
    graph.nodes.push_back(std::move(last));
    return graph;
}

}
