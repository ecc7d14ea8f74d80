#include <gtest/gtest.h>

#include <kit/picture.hpp>

namespace umbral {
namespace {

TEST(Color, the_curve_is_srgb_and_has_an_inverse)
{
    EXPECT_DOUBLE_EQ(srgb_encoded(0), 0);
    EXPECT_DOUBLE_EQ(srgb_encoded(1), 1);
    EXPECT_NEAR(srgb_encoded(0.5), 0.735357, 1e-6);
    EXPECT_NEAR(srgb_encoded(0.002), 0.02584, 1e-9);  // the straight part
    EXPECT_DOUBLE_EQ(srgb_encoded(-1), 0);
    EXPECT_DOUBLE_EQ(srgb_encoded(7), 1);
    // The two parts of the standard's curve meet but for 3e-8.
    for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(srgb_decoded(srgb_encoded(i / 1000.0)), i / 1000.0, 1e-7);
}

TEST(Color, pixels_are_rounded_opaque_and_never_undefined)
{
    EXPECT_EQ(pixel_of({0, 1, 0.5}), glm::u8vec4(0, 255, 188, 255));
    EXPECT_EQ(pixel_of({-1, 9, std::nan("")}), glm::u8vec4(0, 255, 0, 255));
    // Every value of a file comes back.
    for (int i = 0; i < 256; ++i) EXPECT_EQ(pixel_of(srgb_decoded(glm::dvec3(i / 255.0))).r, i);
}

TEST(Picture, halving_takes_means)
{
    Image picture(4, 2, glm::u8vec4(10, 20, 30, 255));
    picture.at(0, 0) = picture.at(1, 1) = glm::u8vec4(20, 20, 30, 255);
    const Image half = halved(picture);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_EQ(half.at(0, 0), glm::u8vec4(15, 20, 30, 255));
    EXPECT_EQ(half.at(1, 0), glm::u8vec4(10, 20, 30, 255));
}

}
}
