#include <umbral/transforms/android.hpp>
#include <umbral/transforms/parametric_graph.hpp>

namespace umbral::transforms {

std::unique_ptr<GraphNode> make_graph_node()
{
    // TODO: write a class that is derived from GraphNode, and make one. An entry is an object or a matrix; where does
    // the matrix lie, so that it stays in its place when the list grows?
    return not_implemented<std::unique_ptr<GraphNode>>();
}

FacadeGraph make_facade(const FacadeParts& parts, float height, float angle)
{
    // TODO: a root; a node for the stretched house; one for the door; one for the window, added three times. Keep the
    // pointers to the two matrices.
    return not_implemented<FacadeGraph>(parts, height, angle);
}

void set_facade_height(const FacadeGraph& facade, float height)
{
    // TODO: write the scaling to where it stands in the graph.
    (void)not_implemented<int>(facade, height);
}

void set_facade_angle(const FacadeGraph& facade, float angle)
{
    // TODO: write the rotation to where it stands in the graph.
    (void)not_implemented<int>(facade, angle);
}

AndroidGraph make_android_graph(const AndroidParts& parts)
{
    // TODO: one node for the limb, one for the head, one with a joint for each place where they hang.
    return not_implemented<AndroidGraph>(parts);
}

}
