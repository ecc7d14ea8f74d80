#include <umbral/transforms/tree.hpp>

namespace umbral::transforms {

void draw_trunk(Pipeline& pipeline)
{
    // TODO: set the colour trunk_fill, and fill triangles that together are the polygon. Then set trunk_edges, and draw
    // the six edges. At the end the colour must be what it was. Delete the next line.
    (void)not_implemented<int>(pipeline);
}

void draw_tree(Pipeline& pipeline, unsigned levels, const Figure& trunk)
{
    // TODO: nothing if there are no levels. Otherwise trunk(pipeline), and for each branch: push, compose the matrix of
    // that branch, draw a tree of one level less, pop. Delete the next line.
    (void)not_implemented<int>(pipeline, levels, trunk);
}

}
