#include <array>
#include <kit/amount.hpp>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "arc_graphs.hpp"
#include "street.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr std::size_t plenty = 10'000;

void record_instances(Recorder& out, const std::vector<Instance>& instances)
{
    for (std::size_t i = 0; i < std::min(instances.size(), plenty); ++i) {
        out.append("objects", instances[i].object);
        out.append("world", instances[i].world);
    }
}

// The facade, its window alone, and rules in small: order, scope, an empty node, a transformation that nothing follows.
void record_known(Variation& vary, Recorder& out)
{
    const auto q = [&](float number) { return by_quarters(vary, number); };
    SceneGraph graph = facade();
    const std::uint32_t names = any_instead(vary, 0U, 0U, 1000);
    for (std::vector<Entry>& entries : graph.nodes)
        for (Entry& entry : entries)
            if (entry.kind == Entry::Kind::object) entry.index += names;
    for (glm::mat4& matrix : graph.transformations) matrix[3] += glm::vec4(vary.near(glm::vec3(0), 0.4F), 0);
    record_instances(out, ask<expand>(out, graph, plenty));
    graph.root = 2;
    record_instances(out, ask<expand>(out, graph, plenty));
    GraphBuilder b;
    const std::uint32_t empty = b.add_node({});
    const std::uint32_t inner =
        b.add_node({object(1), b.move(q(1), q(2)), object(2), node(empty), b.scale(q(3), q(3))});
    b.graph.root =
        b.add_node({b.scale(q(2), q(5)), node(inner), object(3), b.move(q(10), q(20)), node(inner), object(4)});
    record_instances(out, ask<expand>(out, b.graph, plenty));
    b.graph.root = empty;
    record_instances(out, ask<expand>(out, b.graph, plenty));
}

/// Of a cycle, whose last node is the first one again: it begins at its smallest node and ends before it, whoever found
/// it, wherever they began.
std::vector<std::uint32_t> canonical(std::vector<std::uint32_t> path)
{
    path.pop_back();
    std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());
    return path;
}

void record_cycles(Recorder& out, Random& random)
{
    out.text("found.names",
             "1 no cycle: how many instances\n2 a cycle: how many nodes, and which, each plus one\n"
             "3 a path that does not come back: how many nodes, and which, each plus one\n");
    for (int i = 0; i < 60; ++i) {
        const SceneGraph graph = random_chain(random, random.below(2) == 0);
        std::array<float, 10> row{1};
        try {
            row[1] = static_cast<float>(ask<expand>(out, graph, plenty).size());
        } catch (const CycleError& error) {
            const std::vector<std::uint32_t>& given = error.path();
            const bool is_closed = given.size() > 1 && given.front() == given.back();
            const std::vector<std::uint32_t> path = is_closed ? canonical(given) : given;
            row = {is_closed ? 2.0F : 3.0F, static_cast<float>(path.size())};
            for (std::size_t k = 0; k < std::min(path.size(), row.size() - 2); ++k)
                row[k + 2] = static_cast<float>(path[k] + 1);
        }
        out.append("found", std::span<const float>(row));
    }
}

/// 0: nothing, 1: a cycle, 2: too many, 3: out of range, 4: something else; and of nothing, how many instances came.
glm::vec2 thrown_by(Recorder& out, const SceneGraph& graph, std::size_t limit)
{
    try {
        return {0, ask<expand>(out, graph, limit).size()};
    } catch (const CycleError&) {
        return {1, 0};
    } catch (const TooManyInstances&) {
        return {2, 0};
    } catch (const std::out_of_range&) {
        return {3, 0};
    } catch (...) {
        return {4, 0};
    }
}

void name_thrown(Recorder& out)
{
    out.columns("thrown",
                "thrown (0: nothing; 1: CycleError; 2: TooManyInstances; 3: std::out_of_range; 4: something else), "
                "instances");
}

// In pairs: what is in order, and what is not by one.
void record_limits(Recorder& out, Random& random)
{
    name_thrown(out);
    for (int i = 0; i < 42; ++i) {
        SceneGraph good = random_chain(random, false);
        // Nothing leads to this node.
        if (random.below(2) == 0) good.nodes.push_back({node(9999), {Entry::Kind::transformation, 77}});
        SceneGraph bad = good;
        // What is wrong may be anywhere, also in a node without objects.
        const std::vector<std::uint32_t> candidates = reached(good);
        const std::uint32_t where = candidates[random.below(static_cast<std::uint32_t>(candidates.size()))];
        const auto place = random.below(static_cast<std::uint32_t>(good.nodes[where].size()) + 1);
        const auto put = [&](SceneGraph& graph, const Entry& entry) {
            graph.nodes[where].insert(graph.nodes[where].begin() + place, entry);
        };
        constexpr std::size_t largest_limit = std::numeric_limits<std::size_t>::max();
        std::size_t good_limit = largest_limit;
        std::size_t bad_limit = plenty;
        const auto count = static_cast<std::uint32_t>(good.nodes.size());
        const auto what = static_cast<std::uint32_t>(i % 7);
        if (what == 0) bad.root = count;
        if (what == 1) put(bad, node(count + random.below(1000)));
        if (what == 2) put(bad, {Entry::Kind::transformation, 2});
        // An object may have any name.
        if (what == 3) put(bad, node(~0U)), put(good, object(~0U));
        if (what == 4) good = {{}, {{}}, 0}, bad = {}, good_limit = 0;
        if (what > 4) {
            // One object, at least; a limit may be 0.
            const std::uint32_t levels = 1 + i / 7;
            good = bad = doubling(levels, {object(1)});
            good_limit = std::size_t{1} << (levels - 1);
            bad_limit = good_limit - 1;
            // 2^64 objects: one more than fits in a number of 64 bits, and than the largest limit.
            const std::size_t either[] = {plenty, largest_limit};
            if (what == 6) bad = doubling(65, {object(1)}), bad_limit = either[i % 2];
        }
        const bool good_first = random.below(2) == 0;
        for (const bool is_good : {good_first, !good_first})
            out.append("thrown", is_good ? thrown_by(out, good, good_limit) : thrown_by(out, bad, bad_limit));
    }
}

/// Where nodes lead to the next one twice, and the last one is empty: as many ways to nothing, beside five objects.
SceneGraph ways_to_nothing(std::uint32_t levels, Random& random)
{
    SceneGraph graph = doubling(levels, {});
    graph.root = static_cast<std::uint32_t>(graph.nodes.size());
    const Entry step{Entry::Kind::transformation, 0};
    const std::uint32_t name = random.below(1'000'000);
    std::vector<Entry> entries{object(name + 1), node(1), step, object(name + 2), node(levels / 2)};
    for (const std::uint32_t last : {3U, 4U, 5U}) {
        entries.insert(entries.end(), 1 + random.below(4), step);
        entries.insert(entries.end(), {object(name + last), node(levels - 1)});
    }
    graph.nodes.push_back(entries);
    return graph;
}

/// What is drawn, and where, in order.
Amount amount_of(const std::vector<Instance>& instances)
{
    std::vector<glm::vec3> all;
    for (std::size_t i = 0; i < std::min(instances.size(), plenty); ++i)
        all.emplace_back(static_cast<float>(instances[i].object), instances[i].world[3].x, instances[i].world[3].w);
    return Amount().count(instances.size()).in_order(all);
}

// 2^17 ways that lead to nothing, beside five objects; and 2^59 objects.
void record_many_ways(Random& random, Recorder& out)
{
    const SceneGraph graph = ways_to_nothing(18, random);
    record_instances(out, ask<expand>(out, graph, plenty));
    name_thrown(out);
    out.append("thrown", thrown_by(out, graph, 4));
    out.append("thrown", thrown_by(out, graph, 5));
    out.append("thrown", thrown_by(out, doubling(60, {object(1)}), 100'000));
    out.append("thrown", thrown_by(out, doubling(10, {node(5)}), plenty));
}

// Work must grow with the nodes, and not with the ways. A case of its own: what passes before it is counted is
// nobody's.
void record_work(Random& random, Recorder& out)
{
    out.text("blocks.names", "nodes");
    for (const std::uint32_t levels : {6U, 9U, 12U, 15U, 18U}) {
        const SceneGraph some = ways_to_nothing(levels, random);
        record_cost(out, "blocks", levels, [&] { return amount_of(ask<expand>(out, some, plenty)); });
    }
}

void record_conversion(Recorder& out, const std::vector<ArcGraph>& graphs)
{
    out.columns("size", "nodes, entries that draw, transformations");
    for (const ArcGraph& graph : graphs) {
        const SceneGraph result = ask<to_phigs>(out, graph);
        std::size_t drawn = 0;
        for (const std::vector<Entry>& entries : result.nodes)
            for (const Entry& entry : entries) drawn += entry.kind == Entry::Kind::transformation ? 0 : 1;
        out.append("size", glm::vec3(result.nodes.size(), drawn, result.transformations.size()));
        const std::optional<std::vector<Way>> all = ways(result);
        if (!all) {
            constexpr std::array<float, 17> nothing{-1};
            out.append("instances", std::span<const float>(nothing));
            continue;
        }
        for (const auto& [object, word] : *all) {
            const glm::mat4 world = product(result, word);
            std::array<float, 17> row{static_cast<float>(object)};
            std::copy_n(&world[0][0], 16, row.begin() + 1);
            out.append("instances", std::span<const float>(row));
        }
    }
}

std::vector<ArcGraph> random_arc_graphs(Random& random)
{
    std::vector<ArcGraph> all;
    for (int i = 0; i < 40; ++i) all.push_back(random_arc_graph(random));
    return all;
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 30; ++i) record_instances(out, ask<expand>(out, random_graph(c.random), plenty));
     }},
    {"cycles", [](Case& c, Recorder& out) { record_cycles(out, c.random); }},
    {"limits", [](Case& c, Recorder& out) { record_limits(out, c.random); }},
    {"many ways", [](Case& c, Recorder& out) { record_many_ways(c.random, out); }},
    {"work", [](Case& c, Recorder& out) { record_work(c.random, out); }},
    {"conversion", [](Case& c, Recorder& out) { record_conversion(out, known_arc_graphs(c.random)); }},
    {"any conversion", [](Case& c, Recorder& out) { record_conversion(out, random_arc_graphs(c.random)); }},
    {"picture",
     [](Case& c, Recorder& out) {
         SceneGraph graph = street();
         for (glm::mat4& matrix : graph.transformations) matrix[3] += glm::vec4(c.vary.near(glm::vec2(0), 0.2F), 0, 0);
         out.image("colours", draw_street(ask<expand>(out, graph, plenty)));
     }},
};

}
