#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <umbral/core/not_implemented.hpp>
#include <utility>
#include <vector>

namespace umbral::transforms {

/// One entry of a node.
struct Entry {
    enum class Kind : std::uint32_t { object, node, transformation };
    Kind kind = Kind::object;
    std::uint32_t index =
        0;  ///< an object's name, any number; or the place of a node or transformation in its graph's list
};

/// A scene graph in the manner of PHIGS: a node is a list of entries, in the order of drawing, and a transformation
/// acts on all that follows in its own node, and on nothing outside. The same node may be entered from several places:
/// it is drawn once for each way from the root. Course: NodoGrafoEscena, EntradaNGE.
struct SceneGraph {
    std::vector<glm::mat4> transformations;
    std::vector<std::vector<Entry>> nodes;
    std::uint32_t root = 0;
};

/// A simple object, and the matrix that takes it to the world.
struct Instance {
    std::uint32_t object = 0;
    glm::mat4 world{1};
};

/// A node contains itself.
class CycleError : public std::runtime_error {
public:
    /// `path`: nodes, each of which has the next one as an entry; the last one is the first one again, and no other is
    /// there twice.
    explicit CycleError(std::vector<std::uint32_t> path)
        : std::runtime_error("expected a graph without cycles, got a node that contains itself"), path_(std::move(path))
    {
    }
    [[nodiscard]] const std::vector<std::uint32_t>& path() const noexcept { return path_; }

private:
    std::vector<std::uint32_t> path_;
};

/// There are more instances than the caller wants.
class TooManyInstances : public std::runtime_error {
public:
    explicit TooManyInstances(std::size_t limit)
        : std::runtime_error("expected at most " + std::to_string(limit) + " instances, got more")
    {
    }
};

/// All instances of simple objects that the root contains, in the order of drawing. World matrices are products along
/// the way, root first.
///
/// Throws CycleError if a node that can be reached from the root contains itself, with the nodes of one cycle;
/// std::out_of_range if the root, or an entry of such a node, is a place outside its list; TooManyInstances if there
/// are more than `limit`. What cannot be reached from the root is not looked at. Time grows with the entries and with
/// the instances, not with the number of ways: sixty nodes can make 2^59 ways, and none of them need lead to an object.
/// Course: NodoGrafoEscena::visualizarGL; "instanciaciones en el grafo".
[[nodiscard]] std::vector<Instance> expand(const SceneGraph& graph, std::size_t limit);

/// An arc from a node to what it contains, labelled with a product of transformations.
struct Arc {
    std::vector<std::uint32_t> label;  ///< places in the list of transformations, in the order of writing: {0, 2} is T0
                                       ///< · T2; {} is the identity
    Entry target;                      ///< an object or a node
};

/// A scene graph with labelled arcs: a node is the list of its arcs, in any order. An arc's label acts on its own
/// target only. Course: "grafo de escena".
struct ArcGraph {
    std::vector<glm::mat4> transformations;
    std::vector<std::vector<Arc>> nodes;
    std::uint32_t root = 0;
};

/// The PHIGS graph with the same instances, in any order, and the fewest nodes. The arc graph has no cycle, and its
/// places are right.
///
/// The list of transformations stays the same: none is inverted or multiplied out. Each node that the root reaches
/// becomes one node; each of its arcs becomes one entry, in it or in a helper node; nothing is drawn twice, nor shared
/// by two arcs that was not shared. So a node's arcs need as many nodes as there are different labels that are not the
/// beginning of a longer one, and at least one. Course: problem 2.19.
[[nodiscard]] SceneGraph to_phigs(const ArcGraph& graph);

}
