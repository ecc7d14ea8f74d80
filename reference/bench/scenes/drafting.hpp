#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "model.hpp"

namespace umbral::bench::scenes {

/// A polygon in pixels, y down. Seen from `middle` each of its sides is in full view, so that a fan from there fills
/// it.
struct Polygon {
    std::vector<glm::vec2> corners;
    glm::vec2 middle{0};
    glm::u8vec4 color{0, 0, 0, 255};
};

/// A line between two pixels.
struct Segment {
    glm::ivec2 from{0};
    glm::ivec2 to{0};
    glm::u8vec4 color{0, 0, 0, 255};
};

/// A picture in two dimensions, drawn in order.
struct Drawing {
    int width = 256;
    int height = 256;
    glm::u8vec4 background{255};
    std::vector<Polygon> polygons;
    std::vector<Segment> segments;
};

}
