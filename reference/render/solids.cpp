#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "render/sheet.hpp"

namespace umbral::render {
namespace {

/// What a band's (u, v) are.
enum class Wrap {
    around,  ///< u once round the axis, v along the profile
    disc     ///< the disc of the band's largest radius, as it fits into the unit square
};

/// One smooth part of a profile: its points (distance from the axis, height) and how far along it each lies, from 0 to
/// 1.
struct Band {
    std::span<const glm::dvec2> points;
    std::span<const double> along;
    Wrap wrap = Wrap::around;
};

glm::dvec2 on_disc(const Band& band, const glm::dvec3& place)
{
    const double radius = std::max(band.points.front().x, band.points.back().x);
    const bool upwards = band.points.back().x < band.points.front().x;
    return {0.5 + 0.5 * place.x / radius, 0.5 - (upwards ? 0.5 : -0.5) * place.z / radius};
}

void add_band(Surface& surface, const Band& band, int sectors)
{
    std::vector<unsigned> index;
    const auto first_uv = static_cast<unsigned>(surface.uvs.size());
    for (std::size_t j = 0; j < band.points.size(); ++j) {
        const double radius = band.points[j].x;
        for (int i = 0; i <= sectors; ++i) {
            const double u = static_cast<double>(i) / sectors;
            const double angle = 2 * std::numbers::pi * u;
            const glm::dvec3 place(radius * std::sin(angle), band.points[j].y, radius * std::cos(angle));
            surface.uvs.emplace_back(band.wrap == Wrap::disc ? on_disc(band, place) : glm::dvec2(u, band.along[j]));
            if (i == sectors || (i > 0 && radius == 0)) {
                index.push_back(index[j * (static_cast<std::size_t>(sectors) + 1)]);
            } else {
                index.push_back(static_cast<unsigned>(surface.mesh.positions.size()));
                surface.mesh.positions.emplace_back(place);
            }
        }
    }
    add_cells(surface, index, first_uv, sectors, static_cast<int>(band.points.size()) - 1);
}

std::vector<double> shares_of_length(const std::vector<glm::dvec2>& profile)
{
    std::vector<double> along{0};
    for (std::size_t i = 1; i < profile.size(); ++i)
        along.push_back(along.back() + distance(profile[i - 1], profile[i]));
    if (along.back() > 0)
        for (double& one : along) one /= along.back();
    return along;
}

/// Ends that close a side show discs.
enum class Ends { as_sides, discs };

/// A profile turned round the y axis, with an edge at each point that stands twice.
Surface turned(const std::vector<glm::dvec2>& profile, int sectors, Ends ends)
{
    const std::vector<double> along = shares_of_length(profile);
    const std::span<const glm::dvec2> points(profile);
    Surface surface;
    std::size_t first = 0;
    for (std::size_t i = 1; i <= profile.size(); ++i) {
        if (i < profile.size() && profile[i] != profile[i - 1]) continue;
        const std::size_t count = i - first;
        Band band{points.subspan(first, count), std::span(along).subspan(first, count)};
        if (ends == Ends::discs && band.points.front().y == band.points.back().y) band.wrap = Wrap::disc;
        if (count > 1) add_band(surface, band, sectors);
        first = i;
    }
    return surface;
}

/// The side of a cylinder or a cone with v from 0 to 1 along it alone, between the discs of its ends.
Surface capped(const std::vector<glm::dvec2>& side, int sectors)
{
    Surface surface;
    if (side.front().x > 0) surface = turned({{0, side.front().y}, side.front()}, sectors, Ends::discs);
    append(surface, turned(side, sectors, Ends::as_sides));
    if (side.back().x > 0) append(surface, turned({side.back(), {0, side.back().y}}, sectors, Ends::discs));
    return surface;
}

/// The square from -right - up to right + up at `normal`.
Surface square(const glm::vec3& normal, const glm::vec3& right, const glm::vec3& up)
{
    Surface surface;
    surface.mesh.positions = {normal - right - up, normal + right - up, normal - right + up, normal + right + up};
    surface.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    add_cells(surface, {0, 1, 2, 3}, 0, 1, 1);
    return surface;
}

}

void add_cells(Surface& surface, const std::vector<unsigned>& index, unsigned first_uv, int columns, int rows)
{
    const auto add = [&](unsigned a, unsigned b, unsigned c) {
        const glm::uvec3 triangle(index[a], index[b], index[c]);
        if (triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x) return;
        surface.mesh.triangles.push_back(triangle);
        surface.uv_triangles.emplace_back(first_uv + a, first_uv + b, first_uv + c);
    };
    const auto width = static_cast<unsigned>(columns) + 1;
    for (unsigned j = 0; j < static_cast<unsigned>(rows); ++j) {
        for (unsigned i = 0; i + 1 < width; ++i) {
            const unsigned corner = j * width + i;
            add(corner, corner + 1, corner + width + 1);
            add(corner, corner + width + 1, corner + width);
        }
    }
}

void append(Surface& surface, const Surface& other)
{
    const auto positions = static_cast<unsigned>(surface.mesh.positions.size());
    const auto uvs = static_cast<unsigned>(surface.uvs.size());
    surface.mesh.positions.insert(surface.mesh.positions.end(), other.mesh.positions.begin(),
                                  other.mesh.positions.end());
    surface.uvs.insert(surface.uvs.end(), other.uvs.begin(), other.uvs.end());
    for (const glm::uvec3& triangle : other.mesh.triangles) surface.mesh.triangles.push_back(triangle + positions);
    for (const glm::uvec3& triangle : other.uv_triangles) surface.uv_triangles.push_back(triangle + uvs);
}

Surface make_solid(const scene::Box&)
{
    const glm::vec3 x(1, 0, 0);
    const glm::vec3 y(0, 1, 0);
    const glm::vec3 z(0, 0, 1);
    Surface surface = square(z, x, y);
    append(surface, square(x, -z, y));
    append(surface, square(-z, -x, y));
    append(surface, square(-x, z, y));
    append(surface, square(y, x, -z));
    append(surface, square(-y, x, z));
    return surface;
}

Surface make_solid(const scene::Cylinder& cylinder) { return capped({{1, -1}, {1, 1}}, cylinder.sectors); }
Surface make_solid(const scene::Cone& cone) { return capped({{1, -1}, {0, 1}}, cone.sectors); }
Surface make_solid(const scene::Disc& disc) { return turned({{1, 0}, {0, 0}}, disc.sectors, Ends::discs); }

Surface make_solid(const scene::Revolution& revolution)
{
    return turned({revolution.profile.begin(), revolution.profile.end()}, revolution.sectors, Ends::as_sides);
}

}
