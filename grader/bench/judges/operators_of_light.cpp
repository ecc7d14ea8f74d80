#include <algorithm>
#include <cmath>

#include "bench/judges/picture_operators.hpp"
#include "judge/picture/srgb.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Image>;

Result gamma_twice(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return 255 * srgb_encoded(level / 255); });
}

Result gamma_missing(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return 255 * srgb_decoded(level / 255); });
}

template <int percent>
Result brighter(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return level * (1 + percent / 100.0); });
}

Result three_levels_added(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return level + 3; });
}

Result one_channel_off(const Image& picture, Random&)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells) pixel.r = static_cast<std::uint8_t>(0.95 * pixel.r + 0.5);
    return result;
}

Result red_and_blue_swapped(const Image& picture, Random&)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells) std::swap(pixel.r, pixel.b);
    return result;
}

Result negative(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return 255 - level; });
}

Result grey(const Image& picture, Random&)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells)
        pixel = glm::u8vec4(
            glm::u8vec3(static_cast<std::uint8_t>((299 * pixel.r + 587 * pixel.g + 114 * pixel.b + 500) / 1000)),
            pixel.a);
    return result;
}

Result sixteen_levels(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return 17 * std::floor(level / 16); });
}

Result less_contrast(const Image& picture, Random&)
{
    return with_tones(picture, [](double level) { return 128 + 0.94 * (level - 128); });
}

/// A light that reaches a twelfth of the picture only, at a random place of it.
template <int levels>
Result soft_spot(const Image& picture, Random& random)
{
    const double radius = 0.17 * std::min(picture.width, picture.height);
    const glm::dvec2 centre(random.below(static_cast<std::uint32_t>(picture.width)),
                            random.below(static_cast<std::uint32_t>(picture.height)));
    Image result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double part = 1 - glm::distance(centre, glm::dvec2(x, y)) / radius;
            if (part <= 0) continue;
            glm::u8vec4& pixel = result.at(x, y);
            // Light is multiplied by what it falls on: black stays black.
            for (glm::length_t c = 0; c < 3; ++c)
                pixel[c] =
                    static_cast<std::uint8_t>(std::clamp(pixel[c] * (1 + levels / 128.0 * part), 0.0, 255.0) + 0.5);
        }
    return result;
}

Result speckled(const Image& picture, Random& random)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells)
        if (random.below(200) == 0)
            pixel = glm::u8vec4(glm::u8vec3(random.below(2) == 0 ? std::uint8_t{0} : std::uint8_t{255}), pixel.a);
    return result;
}

}

std::vector<PictureOperator> operators_of_light()
{
    return {{"gamma twice", true, gamma_twice},
            {"gamma missing", true, gamma_missing},
            {"3 % too bright", true, brighter<3>},
            {"3 % too dark", true, brighter<-3>},
            {"5 % too bright", true, brighter<5>},
            {"5 % too dark", true, brighter<-5>},
            {"three levels added", true, three_levels_added},
            {"red 5 % too dark", true, one_channel_off},
            {"red and blue swapped", true, red_and_blue_swapped},
            {"negative", true, negative},
            {"grey", true, grey},
            {"sixteen levels", true, sixteen_levels},
            {"less contrast", true, less_contrast},
            {"soft spot too bright", true, soft_spot<24>},
            {"soft spot too dark", true, soft_spot<-24>},
            {"speckled", true, speckled}};
}

}
