#include <umbral/texturing/dice_cube.hpp>

namespace umbral::texturing {

TexturedCube dice_cube()
{
    // TODO: 1. mark the corners of the net: each corner of the grid that a face touches is a vertex
    //       2. fold it: which corner of the cube is each of them?
    //       3. two triangles for each face, anticlockwise as seen from outside
    return not_implemented<TexturedCube>();
}

TexturedCube lit_dice_cube()
{
    // TODO: which vertices of the cube above can still be shared, now that each has one normal?
    return not_implemented<TexturedCube>();
}

TexturedCube replicated_cube()
{
    // TODO: begin with four vertices for each face; then turn the images so that neighbours agree on some of them.
    return not_implemented<TexturedCube>();
}

}
