// Based on: ISO/IEC 9592-1. Programmer's Hierarchical Interactive Graphics System (PHIGS). 1989: structures, elements,
// and their traversal; R. Tarjan. Depth-first Search and Linear Graph Algorithms. SIAM Journal on Computing 1(2), 1972:
// a way back into the path that is being walked is a cycle.

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <umbral/transforms/scene_graph.hpp>

namespace umbral::transforms {
namespace {

/// Each node is visited once, however many ways lead to it.
class Counter {
public:
    Counter(const SceneGraph& graph, std::size_t limit)
        : graph_(graph), limit_(limit), counts_(graph.nodes.size()), begun_(graph.nodes.size(), false)
    {
    }

    /// How many instances a node contains, or the limit if there are more. Throws CycleError, std::out_of_range.
    std::size_t count(std::uint32_t node)
    {
        if (node >= graph_.nodes.size())
            throw std::out_of_range("expected one of " + std::to_string(graph_.nodes.size()) + " nodes, got " +
                                    std::to_string(node));
        if (counts_[node]) return *counts_[node];
        path_.push_back(node);
        if (begun_[node]) throw CycleError({std::find(path_.begin(), path_.end(), node), path_.end()});
        begun_[node] = true;
        std::size_t sum = 0;
        for (const Entry& entry : graph_.nodes[node]) {
            if (entry.kind == Entry::Kind::object) add(1, sum);
            if (entry.kind == Entry::Kind::node) add(count(entry.index), sum);
            if (entry.kind == Entry::Kind::transformation && entry.index >= graph_.transformations.size())
                throw std::out_of_range("expected one of " + std::to_string(graph_.transformations.size()) +
                                        " transformations, got " + std::to_string(entry.index));
        }
        path_.pop_back();
        counts_[node] = sum;
        return sum;
    }

    /// Does any node that was counted contain more than the limit? Then so does each that leads to it.
    [[nodiscard]] bool is_exceeded() const { return is_exceeded_; }
    /// Of a node that was counted.
    [[nodiscard]] bool is_empty(std::uint32_t node) const { return counts_[node] == std::size_t{0}; }

private:
    /// A number beyond the limit may be none that std::size_t holds.
    void add(std::size_t more, std::size_t& sum)
    {
        is_exceeded_ = is_exceeded_ || more > limit_ - sum;
        sum += std::min(more, limit_ - sum);
    }

    const SceneGraph& graph_;
    std::size_t limit_;
    bool is_exceeded_ = false;
    std::vector<std::optional<std::size_t>> counts_;
    std::vector<bool> begun_;
    std::vector<std::uint32_t> path_;
};

/// `world` is a copy: what a node composes ends with it, as between push and pop.
void walk(const SceneGraph& graph, const Counter& counter, std::uint32_t node, glm::dmat4 world,
          std::vector<Instance>& instances)
{
    for (const Entry& entry : graph.nodes[node]) {
        switch (entry.kind) {
            case Entry::Kind::object: instances.push_back({entry.index, glm::mat4(world)}); break;
            case Entry::Kind::transformation: world = world * glm::dmat4(graph.transformations[entry.index]); break;
            case Entry::Kind::node:
                if (!counter.is_empty(entry.index)) walk(graph, counter, entry.index, world, instances);
                break;
        }
    }
}

/// What is left of an arc's label below the transformations that were written already.
struct Branch {
    std::span<const std::uint32_t> label;
    Entry target;
};

class Converter {
public:
    explicit Converter(const ArcGraph& graph) : graph_(graph), result_{graph.transformations, {}, 0} {}

    SceneGraph convert()
    {
        result_.root = place_of(graph_.root);
        return std::move(result_);
    }

private:
    /// Where an arc graph's node stands in the result; it is made the first time.
    std::uint32_t place_of(std::uint32_t node)
    {
        const auto [found, is_new] = places_.try_emplace(node, 0);
        if (!is_new) return found->second;
        const std::uint32_t place = found->second = new_node();
        std::vector<Branch> branches;
        for (const Arc& arc : graph_.nodes[node]) branches.push_back({arc.label, arc.target});
        write(place, branches);
        return place;
    }

    std::uint32_t new_node()
    {
        result_.nodes.emplace_back();
        return static_cast<std::uint32_t>(result_.nodes.size() - 1);
    }

    void add(std::uint32_t place, Entry entry) { result_.nodes[place].push_back(entry); }

    /// Labels that begin alike share their beginning. The last beginning can stay in this node, where nothing comes
    /// after it; each other one needs a helper.
    void write(std::uint32_t place, const std::vector<Branch>& branches)
    {
        std::map<std::uint32_t, std::vector<Branch>> beginnings;
        for (const auto& [label, target] : branches) {
            if (!label.empty())
                beginnings[label.front()].push_back({label.subspan(1), target});
            else if (target.kind == Entry::Kind::node)
                add(place, {Entry::Kind::node, place_of(target.index)});
            else
                add(place, target);
        }
        for (auto i = beginnings.begin(); i != beginnings.end(); ++i) {
            std::uint32_t inside = place;
            if (std::next(i) != beginnings.end()) {
                inside = new_node();
                add(place, {Entry::Kind::node, inside});
            }
            add(inside, {Entry::Kind::transformation, i->first});
            write(inside, i->second);
        }
    }

    const ArcGraph& graph_;
    SceneGraph result_;
    std::map<std::uint32_t, std::uint32_t> places_;
};

}

std::vector<Instance> expand(const SceneGraph& graph, std::size_t limit)
{
    Counter counter(graph, limit);
    counter.count(graph.root);
    if (counter.is_exceeded()) throw TooManyInstances(limit);
    std::vector<Instance> instances;
    walk(graph, counter, graph.root, glm::dmat4(1), instances);
    return instances;
}

SceneGraph to_phigs(const ArcGraph& graph) { return Converter(graph).convert(); }

}
