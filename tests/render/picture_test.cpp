#include <gtest/gtest.h>

#include <cmath>

#include "render/buffers.hpp"
#include "render/picture.hpp"

namespace umbral::render::test {
namespace {

TEST(Srgb, of_values_from_the_standard)
{
    // 0.2140 is the middle grey 127.5 of 255 (IEC 61966-2-1 by hand: ((127.5/255 + 0.055)/1.055)^2.4).
    EXPECT_EQ(to_srgb(0), 0);
    EXPECT_EQ(to_srgb(1), 255);
    EXPECT_EQ(to_srgb(0.2140F), 127);
    EXPECT_EQ(to_srgb(0.2142F), 128);
    EXPECT_EQ(to_srgb(0.0031308F), 10);
    EXPECT_EQ(to_srgb(0.00015F), 0);
    EXPECT_EQ(to_srgb(0.00016F), 1);
    EXPECT_EQ(to_srgb(-1), 0);
    EXPECT_EQ(to_srgb(7), 255);
    EXPECT_EQ(to_srgb(std::nanf("")), 0);
    EXPECT_EQ(to_srgb(INFINITY), 255);
}

TEST(Srgb, decodes_to_what_it_encodes)
{
    for (int i = 0; i < 256; ++i) {
        const double encoded = i / 255.0;
        const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        EXPECT_EQ(to_srgb(static_cast<float>(linear)), i);
    }
}

TEST(Picture, lays_the_frame_over_the_background)
{
    scene::Scene scene;
    scene.background_top = {1, 0, 0};
    scene.background_bottom = {0, 0, 1};
    Frame frame(2, 4);
    frame.color.at(1, 1) = {0, 1, 0, 1};
    const Image image = make_picture(frame, scene);
    EXPECT_EQ(image.at(1, 1), glm::u8vec4(0, 255, 0, 255));
    EXPECT_EQ(image.at(0, 0), glm::u8vec4(to_srgb(0.875F), 0, to_srgb(0.125F), 255));
    EXPECT_EQ(image.at(0, 3), glm::u8vec4(to_srgb(0.125F), 0, to_srgb(0.875F), 255));
}

TEST(Picture, averages_light_and_not_bytes)
{
    Frame frame(2, 2);
    for (glm::vec4& color : frame.color.cells) color = {0, 0, 0, 1};
    frame.color.at(0, 0) = {1, 1, 1, 1};
    frame.color.at(1, 1) = {9, 9, 9, 1};
    const Image image = make_picture(frame, {}, 2);
    ASSERT_EQ(image.cells.size(), 1U);
    EXPECT_EQ(image.at(0, 0), glm::u8vec4(188, 188, 188, 255)) << "half the light is 188 in sRGB, not 128";
    EXPECT_THROW((void)make_picture(Frame(3, 2), {}, 2), std::invalid_argument);
}

TEST(Picture, of_the_other_buffers)
{
    Frame frame(3, 1);
    frame.ids.at(0, 0) = 1;
    frame.ids.at(1, 0) = 2;
    frame.depth.at(0, 0) = 0.5F;
    frame.depth.at(1, 0) = 0.75F;
    EXPECT_EQ(picture_of_depth(frame).at(0, 0).r, 255);
    EXPECT_LT(picture_of_depth(frame).at(1, 0).r, 60);
    EXPECT_EQ(picture_of_depth(frame).at(2, 0).r, 0);
    EXPECT_NE(picture_of_ids(frame).at(0, 0), picture_of_ids(frame).at(1, 0));
    EXPECT_EQ(picture_of_ids(frame).at(2, 0), glm::u8vec4(0, 0, 0, 255));
    EXPECT_EQ(picture_of_coverage(frame).at(1, 0), glm::u8vec4(255));
    EXPECT_EQ(picture_of_depth(Frame(2, 2)).at(0, 0).r, 0) << "nothing was drawn";
}

// The format is NumPy's, version 1.0: numpy.lib.format.
TEST(Npy, has_a_header_of_a_multiple_of_64_bytes)
{
    for (const std::vector<int>& shape : {std::vector<int>{1}, {480, 640}, {1080, 1920, 4}}) {
        const std::array<std::byte, 3> data = {std::byte{1}, std::byte{2}, std::byte{3}};
        const std::vector<std::byte> bytes = npy_bytes("|u1", shape, data);
        std::string text;
        for (const std::byte byte : bytes) text += static_cast<char>(byte);
        EXPECT_EQ(text.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
        const std::size_t header = static_cast<unsigned char>(text[8]) + 256U * static_cast<unsigned char>(text[9]);
        EXPECT_EQ((10 + header) % 64, 0U);
        EXPECT_EQ(text[10 + header - 1], '\n');
        EXPECT_EQ(text.substr(10 + header), "\x01\x02\x03");
        EXPECT_NE(text.find("'shape': (" + std::to_string(shape[0]) + ", "), std::string::npos);
    }
}

}
}
