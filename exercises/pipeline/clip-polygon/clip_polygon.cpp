#include <umbral/pipeline/clip_polygon.hpp>

namespace umbral::pipeline {

std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon, const std::vector<glm::vec2>& window)
{
    // TODO: for each side of the window in turn: walk round what is left of the polygon. Keep the corners to the left
    // of the side's line, and add one where a side of the polygon crosses it.
    return not_implemented<std::vector<glm::vec2>>(polygon, window);
}

}
