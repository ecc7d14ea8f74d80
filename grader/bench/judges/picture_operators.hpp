#pragma once

#include <optional>
#include <umbral/core/random.hpp>
#include <vector>

#include "bench/judges/picture_pair.hpp"

namespace umbral::grader {

/// Something done to the pixels of a right picture.
struct PictureOperator {
    const char* name;
    bool harmful;
    /// Nothing if it does not apply to that picture.
    std::optional<Image> (*apply)(const Image& picture, Random& random);
};

/// What machines do to a right picture that nobody minds: rounding, noise of one level, other owners of edge pixels.
[[nodiscard]] std::vector<PictureOperator> harmless_operators();
/// What wrong programs do to it: moved, mirrored, scaled, another light, holes, cracks, other tones.
[[nodiscard]] std::vector<PictureOperator> harmful_operators();

/// Hands on the picture under every operator, with reproducible random numbers.
void visit_operators(const std::string& scene, const Picture& expected, const VisitPair& visit);

/// The parts of the list of harmful ones.
[[nodiscard]] std::vector<PictureOperator> operators_of_place();
[[nodiscard]] std::vector<PictureOperator> operators_of_light();

/// `picture` with every colour passed through `change(level) -> level`, rounded and clamped; alpha stays.
template <class Change>
[[nodiscard]] Image with_tones(const Image& picture, Change change)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells)
        for (glm::length_t c = 0; c < 3; ++c)
            pixel[c] = static_cast<std::uint8_t>(std::clamp(change(static_cast<double>(pixel[c])), 0.0, 255.0) + 0.5);
    return result;
}

/// The picture whose pixel (x, y) is `picture` at place(x, y), interpolated between pixel centres, its border repeated.
template <class Place>
[[nodiscard]] Image resampled(const Image& picture, Place place)
{
    const auto texel = [&](int x, int y) {
        return glm::dvec4(picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1)));
    };
    Image result(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec2 at = place(glm::dvec2(x, y));
            const glm::dvec2 corner = glm::floor(at);
            const glm::dvec2 part = at - corner;
            const auto left = static_cast<int>(corner.x);
            const auto top = static_cast<int>(corner.y);
            const glm::dvec4 above = glm::mix(texel(left, top), texel(left + 1, top), part.x);
            const glm::dvec4 below = glm::mix(texel(left, top + 1), texel(left + 1, top + 1), part.x);
            result.at(x, y) = glm::u8vec4(glm::mix(above, below, part.y) + 0.5);
        }
    return result;
}

}
