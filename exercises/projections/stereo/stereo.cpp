#include <umbral/projections/stereo.hpp>

namespace umbral::projections {

StereoPair off_axis_pair(const StereoScreen& screen)
{
    // TODO: refuse what is no screen.
    // TODO: for each eye, where do the screen's borders lie as seen from there? The frustum goes through them.
    return not_implemented<StereoPair>(screen);
}

StereoPair toe_in_pair(const StereoScreen& screen)
{
    // TODO: for each eye, turn it towards the screen's middle. How far away is that point from this eye?
    return not_implemented<StereoPair>(screen);
}

float parallax(const StereoScreen& screen, float distance)
{
    // TODO: draw the two eyes, the screen and the point from above, and look for similar triangles.
    return not_implemented<float>(screen, distance);
}

std::optional<float> distance_of_parallax(const StereoScreen& screen, float parallax)
{
    // TODO: solve that for the distance. For which parallaxes is there none?
    return not_implemented<std::optional<float>>(screen, parallax);
}

std::optional<glm::vec2> disparity(const StereoPair& pair, const glm::vec3& point)
{
    // TODO: where does each eye see the point? Right less left.
    return not_implemented<std::optional<glm::vec2>>(pair, point);
}

Image anaglyph(const Image& left, const Image& right, AnaglyphColors colors)
{
    // TODO: red from the left picture, green and blue from the right one, pixel by pixel.
    return not_implemented<Image>(left, right, colors);
}

}
