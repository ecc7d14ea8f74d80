#include <umbral/transforms/matrix_stack.hpp>

namespace umbral::transforms {

std::unique_ptr<MatrixStack> make_matrix_stack()
{
    // TODO: above this function, write a class that derives from MatrixStack: it keeps the view V, the modelling matrix
    // N, and a std::vector of the matrices that were pushed. Return std::make_unique<YourClass>().
    return not_implemented<std::unique_ptr<MatrixStack>>();
}

void draw_simple_figure(Pipeline& pipeline)
{
    // TODO: fill the square (two triangles) with the current colour, then the triangle with pipeline.background();
    // leave the colour as you found it. Delete the next line.
    (void)not_implemented<int>(pipeline);
}

void draw_complex_figure(Pipeline& pipeline, const Figure& figure)
{
    // TODO: call figure(pipeline) three times, with a push, a compose and a pop round those that must move. Delete the
    // next line.
    (void)not_implemented<int>(pipeline, figure);
}

}
