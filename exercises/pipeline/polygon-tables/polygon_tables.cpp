#include <umbral/pipeline/polygon.hpp>

namespace umbral::pipeline {

std::vector<glm::vec2> polygon_loop(std::uint32_t sides)
{
    // TODO: corner i is (cos(2πi/n), sin(2πi/n)), for i = 0 … n-1. Fewer than three sides give an empty table.
    return not_implemented<std::vector<glm::vec2>>(sides);
}

std::vector<glm::vec2> polygon_segments(std::uint32_t sides)
{
    // TODO: for each corner, this one and the next one; the last edge leads back to the first corner, exactly.
    return not_implemented<std::vector<glm::vec2>>(sides);
}

IndexedPolygon polygon_fan(std::uint32_t sides)
{
    // TODO: the corners and, last, the centre; then n triangles and 2n edges, as indices into that table.
    return not_implemented<IndexedPolygon>(sides);
}

}
