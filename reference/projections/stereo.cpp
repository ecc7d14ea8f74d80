// Based on: the course's stereo projections; P. Bourke. Calculating stereo pairs. 1999; E. Dubois. A projection method
// to generate anaglyph stereo images. 2001; ITU-R BT.709 (luminance).

#include <umbral/projections/stereo.hpp>

#include <cmath>
#include <stdexcept>
#include <umbral/lighting/color.hpp>

namespace umbral::projections {
namespace {

void expect_in_range(const StereoScreen& s)
{
    if (!(s.width > 0 && s.height > 0 && s.distance > 0 && s.eye_separation > 0))
        throw std::invalid_argument("a screen's sizes, distance and eye separation must be more than 0");
    if (!(s.near_plane > 0 && s.far_plane > s.near_plane))
        throw std::invalid_argument("expected 0 < near_plane < far_plane");
}

/// The symmetric frustum through the borders of a window of the screen's size, `distance` before the eye. Depth by the
/// ratio of the planes, which is 0 for a far plane at infinity.
glm::dmat4 symmetric_frustum(const StereoScreen& s, double distance)
{
    const double ratio = double{s.near_plane} / s.far_plane;
    return {{2 * distance / s.width, 0, 0, 0},
            {0, 2 * distance / s.height, 0, 0},
            {0, 0, -(1 + ratio) / (1 - ratio), -1},
            {0, 0, -2 * s.near_plane / (1 - ratio), 0}};
}

/// An eye at (x, 0, 0). Relative to it the screen lies aside by -x, and so many halves of its width is the shear.
EyeMatrices off_axis_eye(const StereoScreen& s, double x)
{
    glm::dmat4 view(1);
    view[3].x = -x;
    glm::dmat4 projection = symmetric_frustum(s, s.distance);
    projection[2].x = -2 * x / s.width;
    return {glm::mat4(view), glm::mat4(projection)};
}

/// An eye at (x, 0, 0) that looks at (0, 0, -distance), which is `length` away. Its z axis leads away from that point.
EyeMatrices toe_in_eye(const StereoScreen& s, double x)
{
    const double length = std::hypot(s.distance, x);
    const double cosine = s.distance / length;
    const double sine = x / length;
    const glm::dmat4 view({cosine, 0, sine, 0}, {0, 1, 0, 0}, {-sine, 0, cosine, 0}, {-cosine * x, 0, -sine * x, 1});
    return {glm::mat4(view), glm::mat4(symmetric_frustum(s, length))};
}

/// Clip coordinates of a point, in double.
glm::dvec4 clip_coordinates(const EyeMatrices& eye, const glm::vec3& point)
{
    return glm::dmat4(eye.projection) * (glm::dmat4(eye.view) * glm::dvec4(point, 1));
}

/// The luminance of a pixel as the code of a grey that is as bright.
std::uint8_t luminance_code(const glm::u8vec4& pixel)
{
    const glm::vec3 light = lighting::to_light(glm::u8vec3(pixel));
    return lighting::to_pixel(glm::vec3(dot(light, glm::vec3(0.2126F, 0.7152F, 0.0722F)))).r;
}

glm::u8vec4 mixed(const glm::u8vec4& left, const glm::u8vec4& right, AnaglyphColors colors)
{
    const std::uint8_t red = colors == AnaglyphColors::full ? left.r : luminance_code(left);
    if (colors != AnaglyphColors::gray) return {red, right.g, right.b, 255};
    const std::uint8_t cyan = luminance_code(right);
    return {red, cyan, cyan, 255};
}

}

StereoPair off_axis_pair(const StereoScreen& screen)
{
    expect_in_range(screen);
    const double half = screen.eye_separation / 2.0;
    return {off_axis_eye(screen, -half), off_axis_eye(screen, half)};
}

StereoPair toe_in_pair(const StereoScreen& screen)
{
    expect_in_range(screen);
    const double half = screen.eye_separation / 2.0;
    return {toe_in_eye(screen, -half), toe_in_eye(screen, half)};
}

// Lines from the eyes to the point cut the screen: similar triangles with their tips in the point.
float parallax(const StereoScreen& screen, float distance)
{
    if (!(distance > 0)) throw std::invalid_argument("a point with a parallax lies before the eyes");
    return static_cast<float>(screen.eye_separation * (1 - screen.distance / double{distance}));
}

std::optional<float> distance_of_parallax(const StereoScreen& screen, float parallax)
{
    if (!(parallax <= screen.eye_separation)) return std::nullopt;
    return static_cast<float>(double{screen.eye_separation} * screen.distance /
                              (double{screen.eye_separation} - parallax));
}

std::optional<glm::vec2> disparity(const StereoPair& pair, const glm::vec3& point)
{
    const glm::dvec4 left = clip_coordinates(pair.left, point);
    const glm::dvec4 right = clip_coordinates(pair.right, point);
    if (!(left.w > 0 && right.w > 0)) return std::nullopt;
    return glm::vec2(glm::dvec2(right) / right.w - glm::dvec2(left) / left.w);
}

Image anaglyph(const Image& left, const Image& right, AnaglyphColors colors)
{
    if (left.width != right.width || left.height != right.height)
        throw std::invalid_argument("the pictures for the two eyes must be of one size");
    Image picture(left.width, left.height);
    for (std::size_t i = 0; i < picture.cells.size(); ++i)
        picture.cells[i] = mixed(left.cells[i], right.cells[i], colors);
    return picture;
}

}
