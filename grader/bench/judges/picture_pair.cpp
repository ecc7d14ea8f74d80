#include "bench/judges/picture_pair.hpp"

#include <algorithm>

#include "judge/picture/image_rule.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

Picture to_picture(const Image& image)
{
    const bool opaque = std::ranges::all_of(image.cells, [](const glm::u8vec4& pixel) { return pixel.a == 255; });
    return to_picture(Check{}, as_tensor(image, opaque ? 3 : 4));
}

Image to_image(const Picture& picture)
{
    Image image(picture.width, picture.height, glm::u8vec4(255));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (glm::length_t c = 0; c < (picture.channels == 4 ? 4 : 3); ++c)
                image.at(x, y)[c] = picture.row(picture.channels == 1 ? 0 : static_cast<int>(c), y)[x];
    return image;
}

bool looks_the_same(const Picture& a, const Picture& b)
{
    return std::ranges::all_of(channel_difference(a, b), [](std::uint8_t apart) { return apart <= 2; });
}

}
