#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments)
{
    // TODO: round the positions to 1/256 pixel, as integers. For each pixel in the triangle's box (and in the picture),
    // put its centre into the three edge functions; where all three say "inside", append a Fragment with depth and
    // perspective-correct weights. A centre on an edge counts if that is a top or a left one.
    (void)not_implemented<int>(triangle, width, height, fragments);
}

}
