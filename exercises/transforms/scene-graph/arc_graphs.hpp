#pragma once

#include <map>
#include <optional>

#include "graphs.hpp"

/// Graphs with labelled arcs, and a way to compare what became of them.
namespace umbral::transforms {

inline std::vector<glm::mat4> some_transformations(std::size_t count, Random& random)
{
    std::vector<glm::mat4> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(random_part(random));
    return all;
}

/// The course's: S3 is there by T1·T4, T1·T5 and T2·T5; two that stand for the lost figure of problem 2.19; some with
/// empty labels and equal ones; and one whose root is its last node, and which contains an empty node twice.
inline std::vector<ArcGraph> known_arc_graphs(Random& random)
{
    const std::vector<glm::mat4> t = some_transformations(6, random);
    return {{t,
             {{{{1}, node(1)}, {{2}, node(2)}},
              {{{3}, object(1)}, {{4}, node(3)}, {{5}, node(3)}},
              {{{5}, node(3)}, {{}, object(2)}},
              {{{}, object(3)}}},
             0},
            {t, {{{{1}, object(1)}, {{2}, node(1)}, {{2}, object(4)}}, {{{}, object(1)}, {{3}, object(2)}}}, 0},
            {t, {{{{1, 2, 3}, object(3)}, {{1}, object(1)}, {{1, 2}, object(2)}}}, 0},
            {t,
             {{{{1, 2}, object(1)}, {{1, 3}, object(2)}, {{1, 2, 3}, object(3)}, {{2}, object(4)}, {{1}, object(5)}}},
             0},
            {t, {{{{}, object(1)}, {{}, object(2)}, {{4}, object(3)}, {{4}, object(3)}}}, 0},
            {t,
             {{{{0, 0}, object(1)}, {{0}, node(2)}},
              {{{1}, object(9)}},
              {{{0}, object(2)}, {{1}, object(3)}, {{2}, object(4)}}},
             0},
            {t, {{}, {{{1}, object(1)}, {{2, 3}, node(0)}}, {{{0}, node(1)}, {{0, 1}, object(2)}, {{}, node(0)}}}, 2},
            {t, {{}}, 0}};
}

/// Up to five nodes, the last of which may be empty; labels of up to three of three transformations, so that many begin
/// alike; one node that nothing leads to.
inline ArcGraph random_arc_graph(Random& random)
{
    const std::uint32_t count = 2 + random.below(4);
    const std::vector<std::uint32_t> place = shuffled(count + 1, random);
    ArcGraph graph{some_transformations(3, random), std::vector<std::vector<Arc>>(count + 1), place[0]};
    graph.nodes[place[count]] = {{{0}, object(5)}, {{1}, object(6)}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto label = [&] {
            std::vector<std::uint32_t> factors(random.below(4));
            for (std::uint32_t& factor : factors) factor = random.below(3);
            return factors;
        };
        const std::uint32_t arcs = (i + 1 < count ? 1 : 0) + random.below(5);
        for (std::uint32_t k = 0; k < arcs; ++k) {
            const std::vector<std::uint32_t> factors = label();
            graph.nodes[place[i]].push_back({factors, object(random.below(9))});
        }
        if (i + 1 < count) {
            const std::vector<std::uint32_t> factors = label();
            graph.nodes[place[i]].push_back({factors, node(place[i + 1])});
        }
        const std::uint32_t later = i + 1 + random.below(std::max(1U, count - i - 1));
        const std::vector<std::uint32_t> factors = label();
        if (later < count) graph.nodes[place[i]].push_back({factors, node(place[later])});
    }
    return graph;
}

/// An object, and the transformations on the way to it.
using Way = std::pair<std::uint32_t, std::vector<std::uint32_t>>;

/// All ways through a graph, sorted; none if a place is outside its list, the graph is deeper than 100 nodes, or there
/// are more than 5000 ways.
inline std::optional<std::vector<Way>> ways(const SceneGraph& graph)
{
    constexpr std::size_t most = 5000;
    std::vector<Way> all;
    std::size_t steps = 0;
    const auto walk = [&](const auto& self, std::uint32_t place, std::vector<std::uint32_t> word, int depth) -> bool {
        if (place >= graph.nodes.size() || depth > 100) return false;
        for (const Entry& entry : graph.nodes[place]) {
            if (++steps > 20 * most || all.size() > most || word.size() > 1000) return false;
            if (entry.kind == Entry::Kind::object) {
                all.emplace_back(entry.index, word);
            } else if (entry.kind == Entry::Kind::transformation) {
                if (entry.index >= graph.transformations.size()) return false;
                word.push_back(entry.index);
            } else if (entry.kind != Entry::Kind::node || !self(self, entry.index, word, depth + 1)) {
                return false;
            }
        }
        return true;
    };
    if (!walk(walk, graph.root, {}, 0)) return std::nullopt;
    std::sort(all.begin(), all.end());
    return all;
}

/// The product of a way's transformations.
inline glm::mat4 product(const SceneGraph& graph, const std::vector<std::uint32_t>& word)
{
    glm::dmat4 result(1);
    for (const std::uint32_t i : word) result = result * glm::dmat4(graph.transformations[i]);
    return glm::mat4(result);
}

}
