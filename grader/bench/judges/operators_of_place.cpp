#include <glm/gtc/constants.hpp>

#include "bench/judges/picture_operators.hpp"
#include "bench/judges/picture_pair.hpp"
#include "judge/picture/image_rule.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Image>;

template <int dx, int dy>
Result moved(const Image& picture, Random&)
{
    return resampled(picture, [](glm::dvec2 at) { return at - glm::dvec2(dx, dy); });
}

// Sampled at the pixels' corners instead of their centres.
Result half_a_pixel(const Image& picture, Random&)
{
    return resampled(picture, [](glm::dvec2 at) { return at + 0.5; });
}

Result upside_down(const Image& picture, Random&)
{
    return resampled(picture, [&](glm::dvec2 at) { return glm::dvec2(at.x, picture.height - 1 - at.y); });
}

Result mirrored(const Image& picture, Random&)
{
    return resampled(picture, [&](glm::dvec2 at) { return glm::dvec2(picture.width - 1 - at.x, at.y); });
}

Result axes_swapped(const Image& picture, Random&)
{
    if (picture.width != picture.height) return std::nullopt;
    return resampled(picture, [](glm::dvec2 at) { return glm::dvec2(at.y, at.x); });
}

glm::dvec2 centre_of(const Image& picture) { return 0.5 * (glm::dvec2(picture.width, picture.height) - 1.0); }

Result two_percent_larger(const Image& picture, Random&)
{
    return resampled(picture, [centre = centre_of(picture)](glm::dvec2 at) { return centre + (at - centre) / 1.02; });
}

Result turned_by_a_degree(const Image& picture, Random&)
{
    const double angle = glm::pi<double>() / 180;
    return resampled(picture, [&, centre = centre_of(picture)](glm::dvec2 at) {
        const glm::dvec2 d = at - centre;
        return centre +
               glm::dvec2(std::cos(angle) * d.x - std::sin(angle) * d.y, std::sin(angle) * d.x + std::cos(angle) * d.y);
    });
}

// An aspect ratio forgotten, on a picture of 4 to 3.
Result aspect_ignored(const Image& picture, Random&)
{
    return resampled(picture, [centre = centre_of(picture)](glm::dvec2 at) {
        return glm::dvec2(centre.x + (at.x - centre.x) * 0.75, at.y);
    });
}

glm::u8vec4 background_colour(const Image& image)
{
    const Picture picture = to_picture(image);
    const auto colour = background_of(picture);
    return {colour[0], colour[1], colour[2], picture.channels == 4 ? colour[3] : std::uint8_t{255}};
}

Result blank(const Image& picture, Random&) { return Image(picture.width, picture.height, background_colour(picture)); }

// A pixel of what is shown, not of what is behind it.
std::optional<glm::ivec2> some_content(const Image& picture, const glm::u8vec4& background, Random& random)
{
    for (int tries = 0; tries < 20000; ++tries) {
        const glm::ivec2 at(random.below(static_cast<std::uint32_t>(picture.width)),
                            random.below(static_cast<std::uint32_t>(picture.height)));
        if (picture.at(at.x, at.y) != background) return at;
    }
    return std::nullopt;
}

Result triangle_missing(const Image& picture, Random& random)
{
    const glm::u8vec4 background = background_colour(picture);
    const auto at = some_content(picture, background, random);
    if (!at) return std::nullopt;
    Image result = picture;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x <= y; ++x)
            if (result.contains(at->x - 4 + x, at->y - 6 + y)) result.at(at->x - 4 + x, at->y - 6 + y) = background;
    return result;
}

// A seam that two triangles leave open: one pixel wide, forty long.
Result crack(const Image& picture, Random& random)
{
    const glm::u8vec4 background = background_colour(picture);
    const auto at = some_content(picture, background, random);
    if (!at) return std::nullopt;
    Image result = picture;
    for (int i = -20; i < 20; ++i)
        if (result.contains(at->x + i / 2, at->y + i)) result.at(at->x + i / 2, at->y + i) = background;
    return result;
}

Result quarter_missing(const Image& picture, Random&)
{
    const glm::u8vec4 background = background_colour(picture);
    Image result = picture;
    for (int y = 0; y < picture.height / 2; ++y)
        for (int x = 0; x < picture.width / 2; ++x) result.at(x, y) = background;
    return result;
}

Result blurred(const Image& picture, Random&)
{
    Image result = resampled(picture, [](glm::dvec2 at) { return at + 0.5; });
    return resampled(result, [](glm::dvec2 at) { return at - 0.5; });
}

}

std::vector<PictureOperator> operators_of_place()
{
    return {{"a pixel to the right", true, moved<1, 0>},
            {"a pixel down", true, moved<0, 1>},
            {"a pixel left and up", true, moved<-1, -1>},
            {"two pixels to the left", true, moved<-2, 0>},
            {"half a pixel", true, half_a_pixel},
            {"upside down", true, upside_down},
            {"mirrored", true, mirrored},
            {"axes swapped", true, axes_swapped},
            {"two percent larger", true, two_percent_larger},
            {"turned by a degree", true, turned_by_a_degree},
            {"aspect ignored", true, aspect_ignored},
            {"blank", true, blank},
            {"small triangle missing", true, triangle_missing},
            {"crack", true, crack},
            {"quarter missing", true, quarter_missing},
            {"blurred", true, blurred}};
}

}
