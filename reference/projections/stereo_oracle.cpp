#include <umbral/projections/stereo.hpp>

#include <array>
#include <cmath>
#include <stdexcept>

#include "wide_vector.hpp"

// In 113 bits, rounded to float once, from the four sides of each frustum and each eye's axes as cross products.

namespace umbral::projections {
namespace {

/// The side planes as x and y per unit of depth.
struct Slopes {
    Wide left;
    Wide right;
    Wide bottom;
    Wide top;
};

glm::mat4 frustum(const Slopes& s, const StereoScreen& screen)
{
    glm::mat4 matrix(0);
    matrix[0][0] = static_cast<float>(2 / (s.right - s.left));
    matrix[1][1] = static_cast<float>(2 / (s.top - s.bottom));
    matrix[2][0] = static_cast<float>((s.right + s.left) / (s.right - s.left));
    matrix[2][1] = static_cast<float>((s.top + s.bottom) / (s.top - s.bottom));
    matrix[2][3] = -1;
    const Wide near_plane = screen.near_plane;
    const Wide far_plane = screen.far_plane;
    const bool endless = std::isinf(screen.far_plane);
    matrix[2][2] = endless ? -1 : static_cast<float>(-(far_plane + near_plane) / (far_plane - near_plane));
    matrix[3][2] =
        static_cast<float>(endless ? -2 * near_plane : -2 * far_plane * near_plane / (far_plane - near_plane));
    return matrix;
}

/// An eye at (x, 0, 0) whose z axis has this direction.
glm::mat4 view_along(Wide x, const WideVector& away)
{
    const WideVector z = away / length(away);
    const WideVector rows[] = {{z.z, 0, -z.x}, {0, 1, 0}, z};
    glm::mat4 matrix(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix[column][row] = static_cast<float>(rows[row][static_cast<std::size_t>(column)]);
        matrix[3][row] = static_cast<float>(-rows[row][0] * x);
    }
    return matrix;
}

void expect_in_range(const StereoScreen& s)
{
    for (const float size : {s.width, s.height, s.distance, s.eye_separation, s.near_plane})
        if (!(size > 0)) throw std::invalid_argument("not more than 0");
    if (!(s.far_plane > s.near_plane)) throw std::invalid_argument("far_plane");
}

EyeMatrices off_axis_eye(const StereoScreen& s, Wide x)
{
    const Wide distance = s.distance;
    const Slopes sides{(-Wide{s.width} / 2 - x) / distance, (Wide{s.width} / 2 - x) / distance,
                       -Wide{s.height} / 2 / distance, Wide{s.height} / 2 / distance};
    return {view_along(x, {0, 0, 1}), frustum(sides, s)};
}

EyeMatrices toe_in_eye(const StereoScreen& s, Wide x)
{
    const WideVector away{x, 0, s.distance};
    const Wide across = Wide{s.width} / 2 / length(away);
    const Wide up = Wide{s.height} / 2 / length(away);
    return {view_along(x, away), frustum({-across, across, -up, up}, s)};
}

std::array<Wide, 4> times(const glm::mat4& matrix, const std::array<Wide, 4>& vector)
{
    std::array<Wide, 4> result{};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[static_cast<std::size_t>(row)] += matrix[column][row] * vector[static_cast<std::size_t>(column)];
    return result;
}

long double light_of(std::uint8_t code)
{
    const long double value = code / 255.0L;
    return value <= 0.04045L ? value / 12.92L : std::pow((value + 0.055L) / 1.055L, 2.4L);
}

std::uint8_t luminance_code(const glm::u8vec4& pixel)
{
    const long double light = 0.2126L * light_of(pixel.r) + 0.7152L * light_of(pixel.g) + 0.0722L * light_of(pixel.b);
    const long double value = light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L;
    return static_cast<std::uint8_t>(std::lround(255 * value));
}

}

StereoPair off_axis_pair(const StereoScreen& screen)
{
    expect_in_range(screen);
    const Wide half = Wide{screen.eye_separation} / 2;
    return {off_axis_eye(screen, -half), off_axis_eye(screen, half)};
}

StereoPair toe_in_pair(const StereoScreen& screen)
{
    expect_in_range(screen);
    const Wide half = Wide{screen.eye_separation} / 2;
    return {toe_in_eye(screen, -half), toe_in_eye(screen, half)};
}

float parallax(const StereoScreen& screen, float distance)
{
    if (!(distance > 0)) throw std::invalid_argument("distance");
    if (std::isinf(distance)) return screen.eye_separation;
    return static_cast<float>(screen.eye_separation * (Wide{distance} - screen.distance) / distance);
}

std::optional<float> distance_of_parallax(const StereoScreen& screen, float parallax)
{
    const Wide rest = Wide{screen.eye_separation} - parallax;
    if (!(rest >= 0)) return std::nullopt;
    if (rest == 0) return std::numeric_limits<float>::infinity();
    return static_cast<float>(Wide{screen.eye_separation} * screen.distance / rest);
}

std::optional<glm::vec2> disparity(const StereoPair& pair, const glm::vec3& point)
{
    const std::array<Wide, 4> place{point.x, point.y, point.z, 1};
    const std::array<Wide, 4> left = times(pair.left.projection, times(pair.left.view, place));
    const std::array<Wide, 4> right = times(pair.right.projection, times(pair.right.view, place));
    if (!(left[3] > 0) || !(right[3] > 0)) return std::nullopt;
    return glm::vec2(static_cast<float>(right[0] / right[3] - left[0] / left[3]),
                     static_cast<float>(right[1] / right[3] - left[1] / left[3]));
}

Image anaglyph(const Image& left, const Image& right, AnaglyphColors colors)
{
    if (left.width != right.width || left.height != right.height) throw std::invalid_argument("sizes");
    Image picture = right;
    for (std::size_t i = 0; i < picture.cells.size(); ++i) {
        glm::u8vec4& pixel = picture.cells[i];
        if (colors == AnaglyphColors::gray) pixel.g = pixel.b = luminance_code(right.cells[i]);
        pixel.r = colors == AnaglyphColors::full ? left.cells[i].r : luminance_code(left.cells[i]);
        pixel.a = 255;
    }
    return picture;
}

}
