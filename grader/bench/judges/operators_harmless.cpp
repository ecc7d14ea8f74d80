#include <algorithm>
#include <cstdlib>

#include "bench/judges/picture_operators.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Image>;

int apart(const glm::u8vec4& a, const glm::u8vec4& b)
{
    int most = 0;
    for (glm::length_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return most;
}

void move_levels(glm::u8vec4& pixel, int span, Random& random)
{
    for (glm::length_t c = 0; c < 3; ++c) {
        const int moved =
            int{pixel[c]} + static_cast<int>(random.below(static_cast<std::uint32_t>(2 * span + 1))) - span;
        pixel[c] = static_cast<std::uint8_t>(std::clamp(moved, 0, 255));
    }
}

Result one_level_of_noise(const Image& picture, Random& random)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells) move_levels(pixel, 1, random);
    return result;
}

// Most pixels as they are, a tenth rounded the other way, one in two thousand three levels off.
Result rounding_of_another_vendor(const Image& picture, Random& random)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells) {
        const std::uint32_t dice = random.below(2000);
        if (dice == 0)
            move_levels(pixel, 3, random);
        else if (dice < 200)
            move_levels(pixel, 1, random);
    }
    return result;
}

// A conversion that cuts off instead of rounding: half of the levels come out one lower.
Result cut_off_instead_of_rounded(const Image& picture, Random& random)
{
    Image result = picture;
    for (glm::u8vec4& pixel : result.cells)
        for (glm::length_t c = 0; c < 3; ++c)
            // 0 and 255 are values of full darkness and light, which neither way moves.
            if (pixel[c] > 0 && pixel[c] < 255 && random.below(2) == 0) --pixel[c];
    return result;
}

constexpr int edge = 24;  ///< levels between the two sides
constexpr int alike = 12;

// Three edge pixels in ten get the colour of the other side. Both sides are at least two pixels wide: who owns a pixel
// of a silhouette is a matter of the last bit of a coordinate, but such a bit breaks no line.
Result edge_pixels_re_owned(const Image& picture, Random& random)
{
    Image result = picture;
    bool any = false;
    for (int y = 2; y + 2 < picture.height; ++y)
        for (int x = 2; x + 2 < picture.width; ++x) {
            const int way = static_cast<int>(random.below(4));
            const int dx = way == 0 ? 1 : way == 1 ? -1 : 0;
            const int dy = way == 2 ? 1 : way == 3 ? -1 : 0;
            const glm::u8vec4& here = picture.at(x, y);
            const glm::u8vec4& other = picture.at(x + dx, y + dy);
            const bool solid = apart(here, picture.at(x - dx, y - dy)) <= alike &&
                               apart(other, picture.at(x + 2 * dx, y + 2 * dy)) <= alike;
            if (!solid || apart(here, other) <= edge || random.below(10) >= 3) continue;
            result.at(x, y) = other;
            any = true;
        }
    if (!any) return std::nullopt;
    return result;
}

}

std::vector<PictureOperator> harmless_operators()
{
    return {{"one level of noise", false, one_level_of_noise},
            {"rounding of another vendor", false, rounding_of_another_vendor},
            {"cut off instead of rounded", false, cut_off_instead_of_rounded},
            {"edge pixels re-owned", false, edge_pixels_re_owned}};
}

std::vector<PictureOperator> harmful_operators()
{
    std::vector<PictureOperator> all = operators_of_place();
    for (const PictureOperator& one : operators_of_light()) all.push_back(one);
    return all;
}

void visit_operators(const std::string& scene, const Picture& expected, const VisitPair& visit)
{
    const Image picture = to_image(expected);
    const Picture right = to_picture(picture);
    std::uint64_t seed = 1;
    for (const auto& list : {harmless_operators(), harmful_operators()})
        for (const PictureOperator& one : list) {
            Random random(seed++);
            if (const auto changed = one.apply(picture, random))
                visit({scene, one.name, one.harmful, false, true, right, to_picture(*changed)});
        }
}

}
