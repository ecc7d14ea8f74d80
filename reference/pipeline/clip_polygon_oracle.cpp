#include <cmath>
#include <umbral/pipeline/clip_polygon.hpp>

#include "wide.hpp"

// The polygon passes all sides of the window at once, corner by corner, as in the paper's reentrant form: each stage
// remembers its first and its last corner only. 113 bits, rounded to float once.

namespace umbral::pipeline {
namespace {

struct Point {
    Wide x, y;
};

struct Stage {
    Point from, along;
    bool begun = false;
    Point first{}, last{};
    Wide first_distance = 0, last_distance = 0;

    [[nodiscard]] Wide distance(const Point& p) const { return along.x * (p.y - from.y) - along.y * (p.x - from.x); }
};

class Clipper {
public:
    explicit Clipper(const std::vector<glm::vec2>& window)
    {
        for (std::size_t i = 0; i < window.size(); ++i) {
            const glm::vec2 a = window[i];
            const glm::vec2 b = window[(i + 1) % window.size()];
            stages_.push_back({{a.x, a.y}, {Wide(b.x) - Wide(a.x), Wide(b.y) - Wide(a.y)}});
        }
    }

    void take(const Point& point, std::size_t index = 0)
    {
        if (index == stages_.size()) {
            const glm::vec2 corner(static_cast<float>(point.x), static_cast<float>(point.y));
            if (result_.empty() || corner != result_.back()) result_.push_back(corner);
            return;
        }
        Stage& stage = stages_[index];
        const Wide distance = stage.distance(point);
        if (stage.begun) {
            pass_crossing(stage.last, stage.last_distance, point, distance, index);
        } else {
            stage.begun = true;
            stage.first = point;
            stage.first_distance = distance;
        }
        stage.last = point;
        stage.last_distance = distance;
        if (distance >= 0) take(point, index + 1);
    }

    std::vector<glm::vec2> finished()
    {
        for (std::size_t i = 0; i < stages_.size(); ++i)
            if (const Stage& stage = stages_[i]; stage.begun)
                pass_crossing(stage.last, stage.last_distance, stage.first, stage.first_distance, i);
        while (result_.size() > 1 && result_.back() == result_.front()) result_.pop_back();
        if (result_.size() < 3) result_.clear();
        return result_;
    }

private:
    void pass_crossing(const Point& a, Wide at_a, const Point& b, Wide at_b, std::size_t index)
    {
        if (!((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))) return;
        const Wide span = at_a - at_b;
        take({(at_a * b.x - at_b * a.x) / span, (at_a * b.y - at_b * a.y) / span}, index + 1);
    }

    std::vector<Stage> stages_;
    std::vector<glm::vec2> result_;
};

}

std::vector<glm::vec2> clip_polygon(const std::vector<glm::vec2>& polygon, const std::vector<glm::vec2>& window)
{
    for (const std::vector<glm::vec2>* points : {&polygon, &window}) {
        if (points->size() < 3) return {};
        for (const glm::vec2& point : *points)
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) return {};
    }
    Clipper clipper(window);
    for (const glm::vec2& corner : polygon) clipper.take({corner.x, corner.y});
    return clipper.finished();
}

}
