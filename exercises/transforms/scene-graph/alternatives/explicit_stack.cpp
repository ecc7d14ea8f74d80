// alternative: expands with a stack of its own; converts by sorting the labels and writing them one after the other
#include <deque>
#include <umbral/transforms/scene_graph.hpp>

namespace umbral::transforms {
namespace {

enum class State : std::uint8_t { unseen, open, closed };

// How many instances each node holds; only what the root reaches. Throws if there are more than `limit`.
std::vector<std::size_t> count_instances(const SceneGraph& graph, std::size_t limit)
{
    bool too_many = false;
    std::vector<std::size_t> counts(graph.nodes.size(), 0);
    std::vector<State> states(graph.nodes.size(), State::unseen);
    std::vector<std::pair<std::uint32_t, std::size_t>> open;
    const auto enter = [&](std::uint32_t node) {
        if (node >= graph.nodes.size()) throw std::out_of_range("no such node");
        states[node] = State::open;
        open.emplace_back(node, 0);
    };
    enter(graph.root);
    while (!open.empty()) {
        auto& [node, next] = open.back();
        if (next == graph.nodes[node].size()) {
            for (const Entry& entry : graph.nodes[node]) {
                const std::size_t more = entry.kind == Entry::Kind::object ? 1
                                         : entry.kind == Entry::Kind::node ? counts[entry.index]
                                                                           : 0;
                too_many = too_many || more > limit - counts[node];
                counts[node] = too_many ? limit : counts[node] + more;
            }
            states[node] = State::closed;
            open.pop_back();
            continue;
        }
        const Entry entry = graph.nodes[node][next++];
        if (entry.kind == Entry::Kind::transformation && entry.index >= graph.transformations.size())
            throw std::out_of_range("no such transformation");
        if (entry.kind != Entry::Kind::node) continue;
        if (entry.index < graph.nodes.size() && states[entry.index] == State::open) {
            std::vector<std::uint32_t> path;
            for (const auto& [on_the_way, place] : open)
                if (on_the_way == entry.index || !path.empty()) path.push_back(on_the_way);
            path.push_back(entry.index);
            throw CycleError(path);
        }
        if (entry.index >= graph.nodes.size() || states[entry.index] == State::unseen) enter(entry.index);
    }
    if (too_many) throw TooManyInstances(limit);
    return counts;
}

using Item = std::pair<std::vector<std::uint32_t>, Entry>;

// Sorted labels [first, last) that agree in their first `depth` transformations, which stand in node `place` already. A
// first part that must not act on what follows goes into a node of its own.
void write(SceneGraph& out, std::uint32_t place, const std::vector<Item>& items, std::size_t first, std::size_t last,
           std::size_t depth)
{
    while (first < last && items[first].first.size() == depth) out.nodes[place].push_back(items[first++].second);
    while (first < last) {
        std::size_t end = first;
        while (end < last && items[end].first[depth] == items[first].first[depth]) ++end;
        auto inside = place;
        if (end < last) {
            inside = static_cast<std::uint32_t>(out.nodes.size());
            out.nodes.emplace_back();
            out.nodes[place].push_back({Entry::Kind::node, inside});
        }
        out.nodes[inside].push_back({Entry::Kind::transformation, items[first].first[depth]});
        write(out, inside, items, first, end, depth + 1);
        first = end;
    }
}

}

std::vector<Instance> expand(const SceneGraph& graph, std::size_t limit)
{
    const std::vector<std::size_t> counts = count_instances(graph, limit);
    struct Frame {
        std::uint32_t node;
        std::size_t next;
        glm::mat4 world;
    };
    std::vector<Instance> instances;
    std::deque<Frame> frames{{graph.root, 0, glm::mat4(1)}};
    while (!frames.empty()) {
        Frame& top = frames.back();
        if (top.next == graph.nodes[top.node].size()) {
            frames.pop_back();
            continue;
        }
        const Entry& entry = graph.nodes[top.node][top.next++];
        if (entry.kind == Entry::Kind::object) instances.push_back({entry.index, top.world});
        if (entry.kind == Entry::Kind::transformation) top.world = top.world * graph.transformations[entry.index];
        if (entry.kind == Entry::Kind::node && counts[entry.index] > 0) frames.push_back({entry.index, 0, top.world});
    }
    return instances;
}

SceneGraph to_phigs(const ArcGraph& graph)
{
    // Reached nodes keep their order; helpers come after them.
    std::vector<std::uint32_t> reached{graph.root};
    const auto place_of = [&](std::uint32_t node) {
        const auto found = std::find(reached.begin(), reached.end(), node);
        if (found == reached.end()) return reached.insert(reached.end(), node) - reached.begin();
        return found - reached.begin();
    };
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const Arc& arc : graph.nodes[reached[i]])
            if (arc.target.kind == Entry::Kind::node) place_of(arc.target.index);
    SceneGraph result{graph.transformations, std::vector<std::vector<Entry>>(reached.size()), 0};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        std::vector<Item> items;
        for (const Arc& arc : graph.nodes[reached[i]]) {
            Entry target = arc.target;
            if (target.kind == Entry::Kind::node) target.index = static_cast<std::uint32_t>(place_of(target.index));
            items.emplace_back(arc.label, target);
        }
        std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.first < b.first; });
        write(result, static_cast<std::uint32_t>(i), items, 0, items.size(), 0);
    }
    return result;
}

}
