// alternative: walks along each side by its parameter from the nearer end in long double, in a list that is cut in
// place
#include <cmath>
#include <iterator>
#include <list>
#include <umbral/pipeline/clip_polygon.hpp>

namespace umbral::pipeline {
namespace {

struct Point {
    long double x;
    long double y;
};

using Ring = std::list<Point>;

/// Left of the line from a to b it is positive.
long double side_of(const glm::vec2& a, const glm::vec2& b, const Point& p)
{
    const long double dx = static_cast<long double>(b.x) - a.x;
    const long double dy = static_cast<long double>(b.y) - a.y;
    return dx * (p.y - a.y) - dy * (p.x - a.x);
}

Point between(const Point& p, long double at_p, const Point& q, long double at_q)
{
    if (std::abs(at_q) < std::abs(at_p)) return between(q, at_q, p, at_p);
    const long double t = at_p / (at_p - at_q);
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

void cut(Ring& ring, const glm::vec2& a, const glm::vec2& b)
{
    if (ring.empty()) return;
    const Point first = ring.front();
    const long double at_first = side_of(a, b, first);
    long double at = at_first;
    Point here = first;
    for (auto place = ring.begin(); place != ring.end();) {
        const auto following = std::next(place);
        const Point next = following == ring.end() ? first : *following;
        const long double at_next = following == ring.end() ? at_first : side_of(a, b, next);
        if ((at < 0) != (at_next < 0) && at != 0 && at_next != 0)
            ring.insert(following, between(here, at, next, at_next));
        if (at < 0) ring.erase(place);
        place = following;
        here = next;
        at = at_next;
    }
}

bool usable(const std::vector<glm::vec2>& points)
{
    for (const glm::vec2& p : points)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
    return points.size() >= 3;
}

}

std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon, const std::vector<glm::vec2>& window)
{
    if (!usable(polygon) || !usable(window)) return {};
    Ring ring;
    for (const glm::vec2& p : polygon) ring.push_back({p.x, p.y});
    for (std::size_t i = 0; i < window.size(); ++i) cut(ring, window[i], window[(i + 1) % window.size()]);
    std::vector<glm::vec2> corners;
    for (const Point& p : ring) {
        const glm::vec2 corner(static_cast<float>(p.x), static_cast<float>(p.y));
        if (corners.empty() || corners.back() != corner) corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners.size() < 3 ? std::vector<glm::vec2>{} : corners;
}

}
