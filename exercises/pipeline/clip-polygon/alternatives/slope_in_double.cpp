// alternative: sides as lines n·p = c, crossings by Cramer's rule, in double

#include <umbral/pipeline/clip_polygon.hpp>

namespace umbral::pipeline {
namespace {

struct Line {
    glm::dvec2 normal;
    double offset;
};

Line through(glm::dvec2 a, glm::dvec2 b)
{
    const glm::dvec2 normal(a.y - b.y, b.x - a.x);
    return {normal, a.x * b.y * -1 + a.y * b.x};
}

glm::dvec2 meeting(const Line& one, const Line& other)
{
    const double determinant = one.normal.x * other.normal.y - one.normal.y * other.normal.x;
    return glm::dvec2(one.offset * other.normal.y - other.offset * one.normal.y,
                      one.normal.x * other.offset - other.normal.x * one.offset) /
           determinant;
}

double above(const Line& line, glm::dvec2 p) { return line.normal.x * p.x + line.normal.y * p.y - line.offset; }

}

std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon, const std::vector<glm::vec2>& window)
{
    for (const auto* points : {&polygon, &window})
        for (const glm::vec2& p : *points)
            if (!std::isfinite(p.x + p.y)) return {};
    if (polygon.size() < 3) return {};

    std::vector<glm::dvec2> points(polygon.begin(), polygon.end());
    for (std::size_t i = 0; i < window.size() && !points.empty(); ++i) {
        const Line line = through(window[i], window[(i + 1) % window.size()]);
        std::vector<glm::dvec2> kept;
        glm::dvec2 previous = points.back();
        for (const glm::dvec2& point : points) {
            const double before = above(line, previous);
            const double now = above(line, point);
            if ((before < 0 && now > 0) || (before > 0 && now < 0))
                kept.push_back(meeting(line, through(previous, point)));
            if (now >= 0) kept.push_back(point);
            previous = point;
        }
        points = kept;
    }

    std::vector<glm::vec2> result;
    for (const glm::dvec2& point : points)
        if (result.empty() || result.back() != glm::vec2(point)) result.emplace_back(point);
    while (result.size() > 1 && result.front() == result.back()) result.pop_back();
    return result.size() < 3 ? std::vector<glm::vec2>() : result;
}

}
