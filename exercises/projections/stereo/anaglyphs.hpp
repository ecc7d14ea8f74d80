#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>
#include <umbral/projections/stereo.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../island.hpp"
#include "../volumes.hpp"

/// The cases about anaglyphs, pixel by pixel.
namespace umbral::projections {

inline constexpr AnaglyphColors all_colors[] = {AnaglyphColors::full, AnaglyphColors::half, AnaglyphColors::gray};

/// The pixels of the anaglyph, row by row; rows of nothing if its size is another one.
inline void record_anaglyph(Recorder& out, const Image& left, const Image& right)
{
    const std::string names[] = {"full", "half", "gray"};
    for (const AnaglyphColors colors : all_colors) {
        const Image picture = ask<anaglyph>(out, left, right, colors);
        const bool fits =
            picture.width == left.width && picture.height == left.height && picture.cells.size() == left.cells.size();
        for (std::size_t i = 0; i < left.cells.size(); ++i)
            out.append(names[static_cast<std::size_t>(colors)],
                       fits ? glm::vec4(picture.cells[i]) : glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    }
}

// Pure colours, greys, and all of them against all others, in pictures that are no squares.
inline void record_known_pixels(Variation& vary, Recorder& out)
{
    glm::u8vec4 paints[] = {{255, 0, 0, 255},     {0, 255, 0, 255}, {0, 0, 255, 255},   {255, 255, 255, 255},
                            {128, 128, 128, 255}, {0, 0, 0, 255},   {200, 100, 50, 90}, {20, 120, 220, 10}};
    for (glm::u8vec4& paint : paints)
        paint = glm::u8vec4(glm::clamp(glm::vec4(paint) + vary.near(glm::vec4(0), 40.0F), 0.0F, 255.0F));
    Image left(4, 16);
    Image right(4, 16);
    for (std::size_t i = 0; i < left.cells.size(); ++i) {
        left.cells[i] = paints[i % 8];
        right.cells[i] = paints[i / 8];
    }
    record_anaglyph(out, left, right);

    // As many pixels in another shape, and so dark that the sRGB curve is straight or has just begun to bend.
    left = Image(16, 4);
    right = Image(16, 4);
    const auto grey = [](std::size_t code) {
        return glm::u8vec4(glm::u8vec3(static_cast<std::uint8_t>(code)), std::uint8_t{255});
    };
    for (std::size_t i = 0; i < left.cells.size(); ++i) {
        left.cells[i] = grey(i % 16);
        right.cells[i] = grey(3 * (i / 16));
    }
    record_anaglyph(out, left, right);
}

inline Image random_image(int width, int height, Random& random)
{
    Image image(width, height);
    const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    for (glm::u8vec4& pixel : image.cells)
        for (int channel = 0; channel < 4; ++channel) pixel[channel] = code();
    return image;
}

// Sizes that are no square, one without a pixel, and alpha that must not come through.
inline void record_random_pixels(Random& random, Recorder& out)
{
    for (const glm::ivec2& size : {glm::ivec2(37, 5), {1, 90}, {0, 3}, {20, 24}, {24, 20}}) {
        const Image left = random_image(size.x, size.y, random);
        record_anaglyph(out, left, random_image(size.x, size.y, random));
    }
    for (int i = 0; i < 12; ++i) {
        const Image left = random_image(6, 4, random);
        const bool first = random.below(2) == 1;
        for (const bool differs : {first, !first}) {
            const Image right = random_image(differs && i % 3 != 0 ? 4 : 6, differs && i % 3 != 1 ? 6 : 4, random);
            record_refusal(out, "refused", [&] { return ask<anaglyph>(out, left, right, all_colors[i % 3]); });
        }
    }
}

/// The island as a model that stands in the screen: the lighthouse comes out of it, the sea reaches far behind.
inline void draw_anaglyph(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(480, 300);
    constexpr glm::vec3 sky(0.70F, 0.80F, 0.88F);
    const Island island;
    const glm::mat4 head =
        glm::lookAt(vary.near(glm::vec3(-3.9F, 3.9F, 9.3F), 1.2F), glm::vec3(0.1F, 0.75F, 0), glm::vec3(0, 1, 0));
    const StereoScreen screen{10.4F, 6.5F, 9, 0.6F, 2, 80};
    const StereoPair pair = ask<off_axis_pair>(out, screen);
    const auto seen_by = [&](const EyeMatrices& eye) {
        const Stage stage(size.x, size.y, sky);
        look_through(stage, eye.view * head, eye.projection);
        island.draw_at_sea(stage, sky);
        return stage.picture();
    };
    const Image left = seen_by(pair.left);
    const Image right = seen_by(pair.right);
    out.image("anaglyph", ask<anaglyph>(out, left, right, AnaglyphColors::half));
}

}
