#pragma once

#include <array>
#include <cmath>
#include <kit/color.hpp>
#include <kit/profiles.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/texturing/lab4_program.hpp>

/// The files of the lab, made here: profiles, a label and a plank of wood.
namespace umbral::texturing {

/// A picture of `colour(x, y)` in linear light, x to the right and y up, both in [0, 1].
template <class Colour>
Picture painted_picture(int width, int height, Colour colour)
{
    Picture picture{width, height, {}};
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::u8vec4 pixel = pixel_of(colour((column + 0.5) / width, 1 - (row + 0.5) / height));
            picture.rgb.insert(picture.rgb.end(), {pixel.r, pixel.g, pixel.b});
        }
    return picture;
}

/// How far a place is from a stroke between two others.
inline double stroke(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b)
{
    const glm::dvec2 along = b - a;
    return distance(p, a + along * std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0));
}

/// How far a place is from the letters UMBRAL, each within 0.7 x 1, one for each unit of x.
inline double letters(glm::dvec2 p)
{
    using Strokes = std::array<glm::dvec4, 19>;
    constexpr Strokes strokes = {{{0, 1, 0, 0.2},
                                  {0, 0.2, 0.2, 0},
                                  {0.2, 0, 0.5, 0},
                                  {0.5, 0, 0.7, 0.2},
                                  {0.7, 0.2, 0.7, 1},
                                  {1, 0, 1, 1},
                                  {1, 1, 1.35, 0.45},
                                  {1.35, 0.45, 1.7, 1},
                                  {1.7, 1, 1.7, 0},
                                  {2, 0, 2, 1},
                                  {2, 1, 2.5, 0.95},
                                  {2.5, 0.95, 2.5, 0.55},
                                  {2.5, 0.55, 2, 0.52},
                                  {2.5, 0.55, 2.7, 0.3},
                                  {2.7, 0.3, 2.5, 0.02},
                                  {2.5, 0.02, 2, 0},
                                  {5, 1, 5, 0},
                                  {5, 0, 5.65, 0},
                                  {4, 0, 4.35, 1}}};
    constexpr std::array<glm::dvec4, 6> more = {{{4.35, 1, 4.7, 0},
                                                 {4.13, 0.36, 4.57, 0.36},
                                                 {3, 0, 3, 1},
                                                 {3, 1, 3.6, 0.95},
                                                 {3.6, 0.95, 3.6, 0.55},
                                                 {3.6, 0.55, 3, 0.5}}};
    double nearest = stroke(p, {3.25, 0.5}, {3.68, 0});
    for (const glm::dvec4& s : strokes) nearest = std::min(nearest, stroke(p, {s.x, s.y}, {s.z, s.w}));
    for (const glm::dvec4& s : more) nearest = std::min(nearest, stroke(p, {s.x, s.y}, {s.z, s.w}));
    return nearest;
}

/// 1 inside, 0 outside, over a width of `soft`.
inline double cover(double depth, double soft) { return std::clamp(depth / soft + 0.5, 0.0, 1.0); }

/// The label's colour: an eclipse over a red dusk, twice round the can, and the name below it. `p` in heights of the
/// label, from the middle of one half of it.
inline glm::dvec3 label_colour(glm::dvec2 p)
{
    const glm::dvec3 cream(0.93, 0.80, 0.55);
    const glm::dvec2 from_sun = p - glm::dvec2(0, 0.62);
    const double r = length(from_sun);
    const double angle = std::atan2(from_sun.y, from_sun.x);
    glm::dvec3 color = mix(glm::dvec3(0.20, 0.006, 0.012), glm::dvec3(0.42, 0.03, 0.01), p.y);
    // Rays that get fainter outwards.
    const double ray = cover(std::cos(16 * angle) - 0.25, 0.5) * std::exp(-3.2 * std::max(r - 0.2, 0.0));
    color = mix(color, glm::dvec3(0.80, 0.26, 0.02), 0.7 * ray);
    // The corona and the dark disc.
    color = mix(color, glm::dvec3(1.0, 0.83, 0.45), std::exp(-18 * std::max(r - 0.2, 0.0)));
    color = mix(color, glm::dvec3(0.012, 0.008, 0.012), cover(0.2 - r, 0.012));
    // A band with the name, and lines above and below.
    color = mix(color, glm::dvec3(0.02, 0.012, 0.016), cover(0.135 - std::abs(p.y - 0.235), 0.008));
    for (const double line : {0.085, 0.385, 0.93, 0.06})
        color = mix(color, cream, cover(0.007 - std::abs(p.y - line), 0.008));
    const glm::dvec2 in_name = (p - glm::dvec2(-0.385, 0.165)) / 0.136;
    return mix(color, cream, cover(0.085 - letters(in_name), 0.05));
}

/// 509 x 217: rows of 1527 bytes, which no alignment divides.
inline Picture label_picture()
{
    constexpr double aspect = 509.0 / 217;
    return painted_picture(509, 217, [](double x, double y) {
        return label_colour({(std::fmod(2 * x, 1.0) - 0.5) * aspect / 2, y});
    });
}

/// Wood cut along the trunk: rings that waver. Repeats in both directions.
inline Picture wood_picture()
{
    return painted_picture(251, 253, [](double x, double y) {
        constexpr double turn = 6.283185307179586;
        const double waver =
            0.05 * std::sin(turn * y) + 0.02 * std::sin(turn * (2 * y + x)) + 0.012 * std::sin(turn * (5 * y - x));
        const double ring = 0.5 + 0.5 * std::sin(turn * (7 * (x + waver) + 0.35 * std::sin(turn * (x + waver))));
        const double fibre =
            0.5 + 0.5 * std::sin(turn * (61 * x + 1.5 * std::sin(turn * 3 * y))) * std::sin(turn * (23 * x + y));
        const glm::dvec3 light(0.74, 0.40, 0.14);
        const glm::dvec3 dark(0.27, 0.095, 0.022);
        return mix(mix(light, dark, 0.85 * ring * ring * ring), dark, 0.22 * fibre);
    });
}

/// A profile as a PLY file of vertices.
inline Bytes profile_file(const profiles::Profile& profile, float scale = 1)
{
    meshes::PolygonMesh points;
    for (const glm::vec2& point : profile) points.positions.emplace_back(scale * point, 0);
    const std::string text = meshes::write_ply(points, meshes::PlyFormat::ascii);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline Files lab_files()
{
    return {profile_file(profiles::can_side()),
            profile_file(profiles::can_top()),
            profile_file(profiles::can_bottom()),
            profile_file(profiles::pawn(), 0.62F),
            label_picture(),
            wood_picture()};
}

}
