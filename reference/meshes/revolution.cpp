// Based on: the course's lab on textures, "asignación de coordenadas de textura en objetos obtenidos por revolución".

#include <cmath>
#include <numbers>
#include <umbral/meshes/revolution.hpp>

namespace umbral::meshes {
namespace {

/// Below this length, what is left of a sum of unit normals says nothing about a direction.
constexpr double cancelled = 1e-6;

void check(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    const auto require = [](bool holds, const char* expected) {
        if (!holds) throw std::invalid_argument(std::string("revolve: expected ") + expected);
    };
    require(profile.size() >= 2, "a profile of 2 points or more");
    require(copies >= 4, "4 copies or more: the last one lies on the first");
    for (const glm::vec2& point : profile) {
        require(std::isfinite(point.x) && std::isfinite(point.y), "finite coordinates");
        require(point.x >= 0, "distances from the axis that are not negative");
    }
}

/// Cosine and sine of 2π i / n. Quarter turns are taken out in integers, so that they are exact, and no angle is large.
glm::dvec2 direction(std::uint64_t i, std::uint64_t n)
{
    const std::uint64_t quarters = 4 * i / n % 4;
    const double angle = std::numbers::pi / 2 * static_cast<double>(4 * i % n) / static_cast<double>(n);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    switch (quarters) {
        case 0: return {c, s};
        case 1: return {-s, c};
        case 2: return {-c, -s};
        default: return {s, -c};
    }
}

/// The lengths of the profile up to each of its points. Added up in double: a million points lose 3e-13 of the whole.
std::vector<double> lengths_to(std::span<const glm::vec2> profile)
{
    std::vector<double> lengths{0};
    for (std::size_t j = 1; j < profile.size(); ++j) {
        const glm::dvec2 step = glm::dvec2(profile[j]) - glm::dvec2(profile[j - 1]);
        lengths.push_back(lengths.back() + std::hypot(step.x, step.y));
    }
    if (!(lengths.back() > 0))
        throw std::invalid_argument("revolve: expected a profile of some length, all its points coincide");
    return lengths;
}

/// Of the stretch from one point to the next; zero if they coincide.
glm::dvec2 stretch_normal(const glm::vec2& from, const glm::vec2& to)
{
    const glm::dvec2 step = glm::dvec2(to) - glm::dvec2(from);
    const double size = std::hypot(step.x, step.y);
    return size > 0 ? glm::dvec2(step.y, -step.x) / size : glm::dvec2(0);
}

std::vector<glm::dvec2> profile_normals(std::span<const glm::vec2> profile)
{
    std::vector<glm::dvec2> normals(profile.size(), glm::dvec2(0));
    for (std::size_t j = 0; j + 1 < profile.size(); ++j) {
        const glm::dvec2 normal = stretch_normal(profile[j], profile[j + 1]);
        normals[j] += normal;
        normals[j + 1] += normal;
    }
    for (std::size_t j = 0; j < profile.size(); ++j) {
        if (profile[j].x == 0) normals[j].x = 0;
        const double size = length(normals[j]);
        normals[j] = size < cancelled ? glm::dvec2(0) : normals[j] / size;
    }
    return normals;
}

glm::vec3 turned(const glm::dvec2& v, const glm::dvec2& direction)
{
    return {v.x * direction.x, v.y, -v.x * direction.y};
}

}

TexturedMesh revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    check(profile, copies);
    const std::vector<double> lengths = lengths_to(profile);
    const std::vector<glm::dvec2> normals = profile_normals(profile);
    TexturedMesh result;
    for (std::uint32_t i = 0; i < copies; ++i) {
        const glm::dvec2 towards = direction(i % (copies - 1), copies - 1);
        const double s = static_cast<double>(i) / (copies - 1);
        for (std::size_t j = 0; j < profile.size(); ++j) {
            result.mesh.positions.push_back(turned(glm::dvec2(profile[j]), towards));
            result.normals.push_back(turned(normals[j], towards));
            result.texture_coordinates.emplace_back(s, lengths[j] / lengths.back());
        }
    }
    const auto count = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t i = 0; i + 1 < copies; ++i) {
        for (std::uint32_t j = 0; j + 1 < count; ++j) {
            const std::uint32_t a = i * count + j;
            const std::uint32_t b = a + count;
            if (profile[j] == profile[j + 1]) continue;
            if (profile[j].x != 0) result.mesh.triangles.emplace_back(a, b, b + 1);
            if (profile[j + 1].x != 0) result.mesh.triangles.emplace_back(a, b + 1, a + 1);
        }
    }
    return result;
}

}
