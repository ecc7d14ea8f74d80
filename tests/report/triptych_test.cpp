#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>

#include "judge/image/rule.hpp"
#include "judge/picture/colour_map.hpp"
#include "judge/picture/to_image.hpp"
#include "report/font.hpp"
#include "report/triptych.hpp"

namespace umbral::grader {
namespace {

constexpr glm::u8vec4 red(200, 10, 10, 255);
constexpr glm::u8vec4 blue(10, 10, 200, 255);
constexpr glm::u8vec4 frame_dark(20, 110, 190, 255);

int count(const Image& image, glm::u8vec4 colour) { return static_cast<int>(std::ranges::count(image.cells, colour)); }

template <class Value>
Tensor tensor_of(Element element, std::uint32_t rows, std::uint32_t columns, std::uint32_t components,
                 const std::vector<Value>& values)
{
    Tensor tensor{element, rows, columns, components, {}, {}};
    tensor.bytes.resize(values.size() * sizeof(Value));
    std::memcpy(tensor.bytes.data(), values.data(), tensor.bytes.size());
    return tensor;
}

TEST(ColourMap, is_the_published_magma)
{
    // Rows 0, 64, 128 and 255 of matplotlib's table.
    EXPECT_EQ(magma(0), glm::u8vec4(0, 0, 4, 255));
    EXPECT_EQ(magma(64 / 255.0), glm::u8vec4(81, 18, 124, 255));
    EXPECT_EQ(magma(128 / 255.0), glm::u8vec4(183, 55, 121, 255));
    EXPECT_EQ(magma(1), glm::u8vec4(252, 253, 191, 255));
    EXPECT_EQ(magma(-3), magma(0));
    EXPECT_EQ(magma(3), magma(1));
    EXPECT_EQ(magma(std::numeric_limits<double>::quiet_NaN()), magma(1));
}

TEST(Font, every_letter_looks_different)
{
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:+-/%()=* ";
    std::set<std::string> looks;
    for (const char letter : letters) {
        Image image(letter_width, letter_height, glm::u8vec4(0));
        draw_text(image, 0, 0, std::string(1, letter), red);
        std::string look;
        for (const auto& pixel : image.cells) look += pixel == red ? '#' : ' ';
        looks.insert(look);
    }
    EXPECT_EQ(looks.size(), letters.size());
    Image image(4, 4);
    draw_text(image, -100, 2, "OUTSIDE \xFF", red, 3);  // leaves out what does not fit
    EXPECT_EQ(text_width("AB", 2), 22);
}

TEST(Triptych, frames_and_enlarges_the_worst_region)
{
    const Image reference(300, 200, blue);
    Image yours = reference;
    for (int y = 100; y < 104; ++y)
        for (int x = 200; x < 205; ++x) yours.at(x, y) = red;
    const Image result = triptych(yours, reference);
    // 20 pixels as they are, and each 64 times below.
    EXPECT_EQ(count(result, red), 20 + 20 * 64);
    EXPECT_GE(count(result, magma(1)), 20 + 20 * 64) << "the legend has some too";
    EXPECT_GT(count(result, frame_dark), 0);
    EXPECT_EQ(result.cells, triptych(yours, reference).cells);
}

TEST(Triptych, equal_pictures_have_no_frame)
{
    const Image picture(300, 200, blue);
    const Image result = triptych(picture, picture);
    EXPECT_EQ(count(result, blue), 2 * 300 * 200);
    EXPECT_EQ(count(result, magma(0)), 300 * 200);
    EXPECT_EQ(count(result, frame_dark), 0);
}

TEST(Triptych, one_wrong_pixel_of_a_large_picture_is_seen)
{
    const Image reference(3000, 1500, blue);
    Image yours = reference;
    yours.at(2999, 1499) = red;
    const Image result = triptych(yours, reference);
    EXPECT_LT(result.width, 4100);
    // In the thinned map (its block of the frame's inside), enlarged below, and at the end of the legend.
    EXPECT_GE(count(result, magma(1)), 1 + 64);
    EXPECT_EQ(count(result, red), 64);
}

TEST(Triptych, odd_sizes_are_shown_not_thrown)
{
    for (const auto& [first, second] : {std::pair{Image(40, 30, red), Image(30, 40, blue)},
                                        {Image(), Image(8, 8, blue)},
                                        {Image(8, 8, red), Image()},
                                        {Image(), Image()},
                                        {Image(5, 0), Image(5, 0)},
                                        {Image(1, 3000, red), Image(2, 3000, blue)}}) {
        const Image result = triptych(first, second);
        EXPECT_FALSE(result.cells.empty());
        EXPECT_EQ(count(result, red) > 0, !first.cells.empty() && first.cells[0] == red);
        EXPECT_EQ(count(result, frame_dark), 0);
    }
    EXPECT_FALSE(triptych(Image(1, 1, red), Image(1, 1, blue)).cells.empty());
    EXPECT_FALSE(triptych(Image(2000, 1, red), Image(2000, 1, blue)).cells.empty());
    EXPECT_FALSE(triptych(Image(1, 2000, red), Image(1, 2000, blue)).cells.empty());
}

TEST(ToImage, draws_bytes_floats_ids_and_depth)
{
    Check check;
    check.judge = image_kind();
    check.name = "c/v";
    check.range_low = -1;
    EXPECT_EQ(to_image(tensor_of<std::uint8_t>(Element::uint8, 1, 2, 4, {1, 2, 3, 4, 5, 6, 7, 8}), check).at(1, 0),
              glm::u8vec4(5, 6, 7, 8));
    EXPECT_EQ(to_image(tensor_of<std::uint8_t>(Element::uint8, 2, 1, 3, {1, 2, 3, 4, 5, 6}), check).at(0, 1),
              glm::u8vec4(4, 5, 6, 255));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Image floats =
        to_image(tensor_of<float>(Element::float32, 1, 3, 3, {-1, 0, 1, -9, 9, infinity, 0, nan, 0}), check);
    EXPECT_EQ(floats.at(0, 0), glm::u8vec4(0, 128, 255, 255));
    EXPECT_EQ(floats.at(1, 0), glm::u8vec4(0, 255, 255, 255));
    EXPECT_EQ(floats.at(2, 0), glm::u8vec4(255, 0, 255, 255));
    check.range_low = 0;
    EXPECT_EQ(to_image(tensor_of<float>(Element::float32, 1, 1, 1, {0.2F}), check).at(0, 0),
              glm::u8vec4(51, 51, 51, 255));
    EXPECT_EQ(to_image(tensor_of<double>(Element::float64, 1, 1, 1, {0.2}), check).at(0, 0),
              glm::u8vec4(51, 51, 51, 255));

    std::vector<std::uint32_t> ids(1000);
    for (std::uint32_t i = 0; i < 1000; ++i) ids[i] = i;
    const Image colours = to_image(tensor_of(Element::uint32, 10, 100, 1, ids), check);
    std::set<std::array<int, 3>> distinct;
    for (const auto& colour : colours.cells) distinct.insert({colour.r, colour.g, colour.b});
    EXPECT_EQ(distinct.size(), ids.size());
    EXPECT_EQ(colours.at(0, 0), glm::u8vec4(0, 0, 0, 255));
}

TEST(ToImage, absent_cells_are_transparent_and_odd_tensors_are_refused)
{
    Check check;
    check.judge = image_kind();
    check.name = "c/v";
    Tensor tensor = tensor_of<float>(Element::float32, 1, 2, 1, {0.5F, 0});
    tensor.present = {1, 0};
    EXPECT_EQ(to_image(tensor, check).at(1, 0), glm::u8vec4(0, 0, 0, 0));
    tensor.present = {1};
    EXPECT_THROW((void)to_image(tensor, check), std::invalid_argument);
    EXPECT_THROW((void)to_image(tensor_of<float>(Element::float32, 1, 1, 16, std::vector<float>(16)), check),
                 std::invalid_argument);
    EXPECT_THROW((void)to_image(tensor_of<float>(Element::float32, 5, 5, 1, {1}), check), std::invalid_argument);
    EXPECT_THROW((void)to_image(tensor_of<float>(static_cast<Element>(99), 1, 1, 1, {1}), check),
                 std::invalid_argument);
    check.range_high = check.range_low;
    EXPECT_THROW((void)to_image(tensor_of<float>(Element::float32, 1, 1, 1, {1}), check), std::invalid_argument);
    EXPECT_TRUE(to_image(Tensor{Element::float32, 0, 0, 3, {}, {}}, Check{}).cells.empty());
}

}
}
