#include <algorithm>
#include <array>
#include <span>

#include "render/sheet.hpp"

// Based on: M. Newell. The Utilization of Procedure Models in Digital Image Synthesis. 1975. His 32 bicubic Bézier
// patches are stored by their symmetries: body and lid by one row of control points for each height, which three
// quarter turns make whole; handle and spout by one half, which a reflection makes whole. The numbers are those of his
// tables; the height is the last one there, and y here.
namespace umbral::render {
namespace {

/// A row of control points round the axis: a quarter goes from (radius, 0) over (radius, across) and (across, radius)
/// to (0, radius).
struct Ring {
    double radius;
    double across;
    double height;
};

/// A row round a tube, in the plane of symmetry and off it: half of it goes from `from` over from + side and to + side
/// to `to`.
struct Loop {
    glm::dvec2 from;
    glm::dvec2 to;
    double side;
};

/// From the middle of the bottom up to the inner side of the rim.
constexpr std::array<Ring, 13> body = {{{0, 0, 0},
                                        {1.425, 0.798, 0},
                                        {1.5, 0.84, 0.075},
                                        {1.5, 0.84, 0.15},
                                        {1.5, 0.84, 0.225},
                                        {2, 1.12, 0.45},
                                        {2, 1.12, 0.9},
                                        {2, 1.12, 1.35},
                                        {1.75, 0.98, 1.875},
                                        {1.5, 0.84, 2.4},
                                        {1.4375, 0.805, 2.53125},
                                        {1.3375, 0.749, 2.53125},
                                        {1.4, 0.784, 2.4}}};

/// From its edge to the top of the knob.
constexpr std::array<Ring, 7> lid = {{{1.3, 0.728, 2.4},
                                      {1.3, 0.728, 2.55},
                                      {0.4, 0.224, 2.55},
                                      {0.2, 0.112, 2.7},
                                      {0, 0, 2.85},
                                      {0.8, 0.45, 3.15},
                                      {0, 0, 3.15}}};

/// From its upper end to its lower one.
const std::array<Loop, 7> handle = {{{{-1.6, 2.025}, {-1.5, 2.25}, 0.3},
                                     {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
                                     {{-2.7, 2.025}, {-3, 2.25}, 0.3},
                                     {{-2.7, 1.8}, {-3, 1.8}, 0.3},
                                     {{-2.7, 1.575}, {-3, 1.35}, 0.3},
                                     {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
                                     {{-2, 0.9}, {-1.9, 0.6}, 0.3}}};

/// From the body to its mouth.
const std::array<Loop, 7> spout = {{{{1.7, 1.425}, {1.7, 0.6}, 0.66},
                                    {{2.6, 1.425}, {3.1, 0.825}, 0.66},
                                    {{2.3, 2.1}, {2.4, 2.025}, 0.25},
                                    {{2.7, 2.4}, {3.3, 2.4}, 0.25},
                                    {{2.8, 2.475}, {3.525, 2.49375}, 0.25},
                                    {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
                                    {{2.8, 2.4}, {3.2, 2.4}, 0.15}}};

/// His body has radius 2.
constexpr double size = 0.5;

/// Control points come one after another round the row, three a patch.
glm::dvec3 control(const Ring& ring, int column)
{
    const std::array<glm::dvec2, 4> axes = {{{-1, 0}, {0, 1}, {1, 0}, {0, -1}}};  // (x, z), the handle's first
    const auto quarter = static_cast<std::size_t>(column / 3);
    const glm::dvec2& from = axes[quarter];
    const glm::dvec2& to = axes[(quarter + 1) % 4];
    const glm::dvec2 place = column % 3 == 0   ? ring.radius * from
                             : column % 3 == 1 ? ring.radius * from + ring.across * to
                                               : ring.across * from + ring.radius * to;
    return {place.x, ring.height, place.y};
}

glm::dvec3 control(const Loop& loop, int column)
{
    const glm::dvec2& place = column >= 2 && column <= 4 ? loop.to : loop.from;
    const double side = column % 3 == 0 ? 0 : column < 3 ? loop.side : -loop.side;
    return {place, side};
}

/// Bernstein's polynomials of degree 3.
std::array<double, 4> weights(double t)
{
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// A part of so many patches round by (rows.size() - 1) / 3 along, at (u, v) in the unit square.
template <class Row>
glm::dvec3 place_on(std::span<const Row> rows, int round, const glm::dvec2& uv)
{
    const int along = static_cast<int>(rows.size() - 1) / 3;
    const glm::ivec2 patch = glm::min(glm::ivec2(uv * glm::dvec2(round, along)), glm::ivec2(round, along) - 1);
    const std::array<double, 4> of_u = weights(uv.x * round - patch.x);
    const std::array<double, 4> of_v = weights(uv.y * along - patch.y);
    glm::dvec3 place(0);
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            place += of_u[i] * of_v[j] *
                     control(rows[static_cast<std::size_t>(3 * patch.y) + j],
                             (3 * patch.x + static_cast<int>(i)) % (3 * round));
    return size * place;
}

template <class Row>
Surface part(std::span<const Row> rows, int round, int subdivisions, Seams seams)
{
    return sheet(round * subdivisions, static_cast<int>(rows.size() - 1) / 3 * subdivisions, seams,
                 [&](const glm::dvec2& uv) { return place_on(rows, round, uv); });
}

}

Surface make_solid(const scene::Teapot& teapot)
{
    const int n = teapot.subdivisions;
    Surface surface = part(std::span<const Ring>(body), 4, n, {.u = true, .south = true});
    append(surface, part(std::span<const Ring>(lid), 4, n, {.u = true, .north = true}));
    append(surface, part(std::span<const Loop>(handle), 2, n, {.u = true}));
    append(surface, part(std::span<const Loop>(spout), 2, n, {.u = true}));
    return surface;
}

}
