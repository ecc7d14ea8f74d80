// alternative: the usual way: windows at the near plane for frustum_matrix, view_matrix for the eyes; mostly in float
// will do
#include <stdexcept>
#include <umbral/lighting/color.hpp>
#include <umbral/projections/frustum.hpp>
#include <umbral/projections/stereo.hpp>
#include <umbral/projections/view.hpp>

namespace umbral::projections {
namespace {

bool positive(float number) { return number > 0; }

void check(const StereoScreen& s)
{
    const bool sizes = positive(s.width) && positive(s.height) && positive(s.distance) && positive(s.eye_separation);
    if (!sizes || !positive(s.near_plane) || !(s.near_plane < s.far_plane)) throw std::invalid_argument("screen");
}

EyeMatrices parallel_eye(const StereoScreen& s, float eye_x)
{
    const float to_near = s.near_plane / s.distance;
    const glm::vec3 eye(eye_x, 0, 0);
    return {view_matrix(eye, eye + glm::vec3(0, 0, -1), {0, 1, 0}),
            frustum_matrix({(-s.width / 2 - eye_x) * to_near, (s.width / 2 - eye_x) * to_near, -s.height / 2 * to_near,
                            s.height / 2 * to_near, s.near_plane, s.far_plane})};
}

EyeMatrices convergent_eye(const StereoScreen& s, float eye_x)
{
    const glm::vec3 eye(eye_x, 0, 0);
    const glm::vec3 middle(0, 0, -s.distance);
    const float to_near = s.near_plane / glm::distance(eye, middle);
    const float right = s.width / 2 * to_near;
    const float top = s.height / 2 * to_near;
    return {view_matrix(eye, middle, {0, 1, 0}), frustum_matrix({-right, right, -top, top, s.near_plane, s.far_plane})};
}

float luminance(const glm::u8vec4& pixel)
{
    const glm::vec3 light = lighting::to_light(glm::u8vec3(pixel));
    return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b;
}

}

StereoPair off_axis_pair(const StereoScreen& screen)
{
    check(screen);
    return {parallel_eye(screen, -screen.eye_separation / 2), parallel_eye(screen, screen.eye_separation / 2)};
}

StereoPair toe_in_pair(const StereoScreen& screen)
{
    check(screen);
    return {convergent_eye(screen, -screen.eye_separation / 2), convergent_eye(screen, screen.eye_separation / 2)};
}

float parallax(const StereoScreen& screen, float distance)
{
    if (!positive(distance)) throw std::invalid_argument("distance");
    if (std::isinf(distance)) return screen.eye_separation;
    return screen.eye_separation * ((distance - screen.distance) / distance);
}

std::optional<float> distance_of_parallax(const StereoScreen& screen, float parallax)
{
    if (parallax > screen.eye_separation) return {};
    if (parallax == screen.eye_separation) return std::numeric_limits<float>::infinity();
    return screen.distance / (1 - parallax / screen.eye_separation);
}

std::optional<glm::vec2> disparity(const StereoPair& pair, const glm::vec3& point)
{
    glm::dvec2 places[2];
    int count = 0;
    for (const EyeMatrices& eye : {pair.left, pair.right}) {
        const glm::dvec4 clip = glm::dmat4(eye.projection) * glm::dmat4(eye.view) * glm::dvec4(point, 1);
        if (clip.w <= 0) return {};
        places[count++] = {clip.x / clip.w, clip.y / clip.w};
    }
    return glm::vec2(places[1] - places[0]);
}

Image anaglyph(const Image& left, const Image& right, AnaglyphColors colors)
{
    if (left.width != right.width || left.height != right.height) throw std::invalid_argument("size");
    Image result(left.width, left.height, {0, 0, 0, 255});
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            glm::u8vec4& pixel = result.at(x, y);
            const glm::vec3 gray(luminance(left.at(x, y)), luminance(right.at(x, y)), 0);
            const glm::u8vec3 codes = lighting::to_pixel(gray);
            pixel.r = colors == AnaglyphColors::full ? left.at(x, y).r : codes.r;
            pixel.g = colors == AnaglyphColors::gray ? codes.g : right.at(x, y).g;
            pixel.b = colors == AnaglyphColors::gray ? codes.g : right.at(x, y).b;
        }
    return result;
}

}
