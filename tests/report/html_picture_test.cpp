#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <umbral/core/png.hpp>

#include "report/html/picture.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader::html {
namespace {

/// Read back by the project's reader, which has tests against OpenCV.
Image decoded(const Picture& picture)
{
    const umbral::test::TemporaryFolder folder;
    folder.write("picture.png", picture.png);
    return read_png(folder / "picture.png");
}

Image noise(int width, int height, unsigned colours, bool opaque)
{
    std::mt19937 random(5);
    Image image(width, height);
    for (glm::u8vec4& cell : image.cells) {
        const unsigned number = static_cast<unsigned>(random()) % colours;
        cell = {number & 255U, number >> 8U & 255U, number >> 16U & 255U, opaque ? 255 : random() & 255U};
    }
    return image;
}

TEST(Picture, no_pixel_is_lost)
{
    for (const unsigned colours : {1U, 2U, 255U, 256U, 257U, 1U << 24U})
        for (const bool opaque : {true, false}) {
            const Image image = noise(37, 23, colours, opaque);
            EXPECT_EQ(decoded(encode(image)).cells, image.cells) << colours << (opaque ? " opaque" : "");
        }
}

TEST(Picture, a_palette_saves_room)
{
    Image image(512, 512, {10, 20, 30, 255});
    for (int x = 0; x < 512; ++x) image.at(x, x) = {200, 0, 0, 255};
    EXPECT_LT(encode(image).png.size(), 2500U);
}

TEST(Picture, an_empty_one_stays_empty) { EXPECT_TRUE(encode({}).png.empty()); }

TEST(Picture, is_an_address_for_an_attribute)
{
    const Markup url = data_url(encode(Image(1, 1)));
    EXPECT_TRUE(url.view().starts_with("data:image/png;base64,iVBORw0KGgo")) << "the signature of PNG";
    EXPECT_EQ(url.view().find_first_of("\"'<>& \n"), std::string_view::npos);
}

}
}
