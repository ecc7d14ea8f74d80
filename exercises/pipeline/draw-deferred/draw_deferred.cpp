#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/draw.hpp>

namespace umbral::pipeline {

// A class of your own that derives from IndexedDrawing goes here. Keep in it the names of your vertex array and of your
// buffers.

std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh)
{
    // TODO: make one vertex array object and three buffers, upload positions, colours and indices, and say where
    // attributes 0 and 1 are. draw() then binds the vertex array, calls glDrawElements once, and binds vertex array 0;
    // the destructor deletes what was made.
    return not_implemented<std::unique_ptr<IndexedDrawing>>(mesh);
}

}
