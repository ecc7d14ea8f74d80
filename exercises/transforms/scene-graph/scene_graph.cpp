#include <umbral/transforms/scene_graph.hpp>

namespace umbral::transforms {

std::vector<Instance> expand(const SceneGraph& graph, std::size_t limit)
{
    // TODO: above this function, write one that walks a node with a matrix: an object makes an instance, a
    // transformation is multiplied to the matrix from the right, a node is walked with a copy of the matrix. Watch for
    // nodes that are still being walked: throw CycleError(path).
    return not_implemented<std::vector<Instance>>(graph, limit);
}

SceneGraph to_phigs(const ArcGraph& graph)
{
    // TODO: for each node, put together the arcs whose labels begin with the same transformation.
    return not_implemented<SceneGraph>(graph);
}

}
