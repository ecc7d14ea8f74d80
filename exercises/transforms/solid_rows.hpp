#pragma once

#include <tuple>

#include "drawn_events.hpp"

/// Solids of revolution that were drawn, as rows that depend neither on the order of drawing nor on how each was turned
/// about its own axis.
namespace umbral::transforms {

/// A code, the middle, six numbers for the axis, six for the radius in all directions, and a colour.
using SolidRow = std::array<float, 19>;

struct DrawnSolid {
    SolidRow row{};
    std::tuple<double, double, double> key;  ///< what it is sorted by
    int place = 0;                           ///< among the solids that were drawn
};

/// Turned or mirrored about its own axis y, a solid looks the same: the sum of the squares of its other two axes stays.
/// A cylinder looks the same from its other end: its middle stays, and the product of its axis with itself.
inline SolidRow solid_row(Primitive primitive, const glm::dmat4& m, const glm::vec3& color)
{
    const glm::dvec3 x(m[0]);
    const glm::dvec3 y(m[1]);
    const glm::dvec3 z(m[2]);
    const bool is_cylinder = primitive == Primitive::cylinder;
    const glm::dvec3 middle = glm::dvec3(m[3]) + (is_cylinder ? 0.5 : 0.0) * y;
    const glm::dmat3 square = outerProduct(x, x) + outerProduct(z, z);
    // Divided by the length, it grows as the axis does.
    const glm::dmat3 axis = is_cylinder && length(y) > 0 ? outerProduct(y, y / length(y)) : glm::dmat3(y, {}, {});
    const auto six = [](const glm::dmat3& s) {
        return std::array{s[0][0], s[1][1], s[2][2], s[0][1], s[0][2], s[1][2]};
    };
    SolidRow row{static_cast<float>(primitive)};
    std::size_t i = 1;
    const auto add = [&](double number) { row[i++] = static_cast<float>(number); };
    for (int k = 0; k < 3; ++k) add(middle[k]);
    for (const double number : six(axis)) add(number);
    for (const double number : six(square)) add(number);
    for (int k = 0; k < 3; ++k) add(color[k]);
    return row;
}

/// The solids in an order that is theirs: by kind, by radius, and by where they are in the android's own coordinates,
/// along a direction in which no two of them are alike.
inline std::vector<DrawnSolid> sorted_solids(const RecordingPipeline& drawn, const Start& start)
{
    const auto finite = [](double number) { return std::isfinite(number) ? number : 1e30; };
    const glm::dmat4 to_android = inverse(glm::dmat4(start.modelview));
    std::vector<DrawnSolid> solids;
    for (const Call& call : drawn.calls()) {
        if (call.kind != Call::Kind::primitive) continue;
        const SolidRow own = solid_row(call.primitive, to_android * call.modelview, call.color);
        const double radius = std::sqrt(0.5 * (double{own[10]} + own[11] + own[12]));
        const double along =
            own[1] + 0.618 * own[2] + 0.314 * own[3] + 0.273 * own[4] + 0.571 * own[5] + 0.131 * own[6];
        solids.push_back({solid_row(call.primitive, call.modelview, call.color),
                          {static_cast<double>(call.primitive), finite(std::round(100 * radius)), finite(along)},
                          static_cast<int>(solids.size())});
    }
    std::stable_sort(solids.begin(), solids.end(),
                     [](const DrawnSolid& a, const DrawnSolid& b) { return a.key < b.key; });
    return solids;
}

}
