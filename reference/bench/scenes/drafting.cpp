// Polygons filled scan line by scan line, and lines stepped pixel by pixel, right and wrong. Compiled several times, as
// software.cpp is.

#include "drafting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "software.hpp"

namespace umbral::bench::scenes {
namespace {

using Real = UMBRAL_REAL;

class Sheet {
public:
    Sheet(const Drawing& drawing, Flaw flaw, Way way)
        : flaw_(flaw), way_(way), image_(drawing.width, drawing.height, drawing.background)
    {
    }

    void fill(const Polygon& polygon)
    {
        for (int y = 0; y < image_.height; ++y) fill_row(polygon, y);
    }

    void draw(Segment s)
    {
        if (way_ == Way::ends_swapped) std::swap(s.from, s.to);
        if (flaw_ == Flaw::line_end_missing) s.to = s.from + (s.to - s.from) * 4 / 5;
        if (flaw_ == Flaw::half_pixel_centre || flaw_ == Flaw::floor_for_round)
            step(s, flaw_ == Flaw::half_pixel_centre ? Real(0.5) : Real(0));
        else if (way_ == Way::incremental_steps)
            add_up(s);
        else
            midpoint(s);
    }

    [[nodiscard]] const Image& picture() const { return image_; }

private:
    void put(int x, int y, const glm::u8vec4& color)
    {
        if (image_.contains(x, y)) image_.at(x, y) = color;
        if (flaw_ == Flaw::line_width_wrong && image_.contains(x + 1, y)) image_.at(x + 1, y) = color;
    }

    /// Where the sides cross the middle of row y, in order.
    void find_crossings(const Polygon& polygon, int y)
    {
        crossings_.clear();
        const Real middle = static_cast<Real>(y) + (flaw_ == Flaw::half_pixel_centre ? Real(0) : Real(0.5));
        const std::size_t count = polygon.corners.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (flaw_ == Flaw::last_edge_missing && i + 1 == count) break;
            const glm::vec<2, Real> a(polygon.corners[i]);
            const glm::vec<2, Real> b(polygon.corners[(i + 1) % count]);
            const auto& upper = a.y <= b.y ? a : b;
            const auto& lower = a.y <= b.y ? b : a;
            // A side owns its upper end and not its lower one; otherwise a corner on the row would count twice.
            const bool crosses =
                upper.y <= middle && (flaw_ == Flaw::vertex_counted_twice ? middle <= lower.y : middle < lower.y);
            if (!crosses || upper.y == lower.y) continue;
            const Real slope = (lower.x - upper.x) / (lower.y - upper.y);
            if (way_ == Way::incremental_steps) {
                // From the side's first row down, one slope a row.
                const Real first = std::ceil(upper.y - Real(0.5)) + Real(0.5);
                Real x = upper.x + (first - upper.y) * slope;
                for (Real row = first; row < middle; row += 1) x += slope;
                crossings_.push_back(x);
            } else if (way_ == Way::equal_formulas || way_ == Way::ends_swapped) {
                crossings_.push_back(lower.x - (lower.y - middle) * slope);
            } else {
                crossings_.push_back(upper.x + (middle - upper.y) * slope);
            }
        }
        std::sort(crossings_.begin(), crossings_.end());
    }

    void fill_row(const Polygon& polygon, int y)
    {
        find_crossings(polygon, y);
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
            // Pixels whose centre lies between the two, or on the left one.
            const Real shift = flaw_ == Flaw::half_pixel_centre || flaw_ == Flaw::floor_for_round ? Real(0) : Real(0.5);
            int first = static_cast<int>(std::ceil(crossings_[i] - shift));
            int last = static_cast<int>(std::ceil(crossings_[i + 1] - shift)) - 1;
            if (flaw_ == Flaw::ends_both_filled) {
                --first;
                ++last;
            }
            for (int x = std::max(first, 0); x <= std::min(last, image_.width - 1); ++x)
                image_.at(x, y) = polygon.color;
        }
    }

    /// In whole numbers. Based on: J. Bresenham. Algorithm for Computer Control of a Digital Plotter. 1965.
    void midpoint(const Segment& s)
    {
        const glm::ivec2 d = glm::abs(s.to - s.from);
        const bool steep = d.y > d.x && flaw_ != Flaw::steep_lines_gappy;
        const int steps = steep ? d.y : d.x;
        const int sideways = steep ? d.x : d.y;
        const glm::ivec2 towards(s.to.x < s.from.x ? -1 : 1, s.to.y < s.from.y ? -1 : 1);
        glm::ivec2 at = s.from;
        int error = steps / 2;
        for (int i = 0; i <= steps; ++i) {
            put(at.x, at.y, s.color);
            error -= sideways;
            while (error < 0 && steps > 0) {
                error += steps;
                (steep ? at.x : at.y) += steep ? towards.x : towards.y;
            }
            (steep ? at.y : at.x) += steep ? towards.y : towards.x;
        }
    }

    /// A slope added step by step, each place rounded to the nearest pixel.
    void add_up(const Segment& s)
    {
        const glm::ivec2 d = s.to - s.from;
        const int steps = std::max(std::abs(d.x), std::abs(d.y));
        const glm::vec<2, Real> slope = glm::vec<2, Real>(d) / static_cast<Real>(std::max(steps, 1));
        glm::vec<2, Real> at(s.from);
        for (int i = 0; i <= steps; ++i, at += slope)
            put(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)), s.color);
    }

    /// Places rounded down instead, `moved` pixels further on.
    void step(const Segment& s, Real moved)
    {
        const glm::ivec2 d = s.to - s.from;
        const int steps = std::max(std::abs(d.x), std::abs(d.y));
        for (int i = 0; i <= steps; ++i) {
            const glm::vec<2, Real> at =
                glm::vec<2, Real>(s.from) +
                glm::vec<2, Real>(d) * (static_cast<Real>(i) / static_cast<Real>(std::max(steps, 1))) - moved;
            put(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), s.color);
        }
    }

    Flaw flaw_;
    Way way_;
    Image image_;
    std::vector<Real> crossings_;
};

}

namespace UMBRAL_BUILD {

Image draft(const Drawing& drawing, Flaw flaw, Way way)
{
    Sheet sheet(drawing, flaw, way);
    for (const Polygon& polygon : drawing.polygons) sheet.fill(polygon);
    for (const Segment& segment : drawing.segments) sheet.draw(segment);
    return sheet.picture();
}

}

}
