#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/judges/picture_operators.hpp"
#include "bench/judges/picture_rules.hpp"

namespace umbral::grader {
namespace {

/// A bright disc with a gradient and three stripes, off the centre: nothing about it is symmetric.
Image disc()
{
    Image image(160, 160, glm::u8vec4(10, 12, 30, 255));
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) {
            const int d = (x - 70) * (x - 70) + (y - 85) * (y - 85);
            if (d < 50 * 50) image.at(x, y) = glm::u8vec4(230 - d / 20, 60 + y, (x / 9) % 3 == 0 ? 40 : 90, 255);
        }
    return image;
}

TEST(PictureOperators, all_have_names_of_their_own)
{
    std::set<std::string> names;
    std::size_t count = 0;
    for (const auto& list : {harmless_operators(), harmful_operators()})
        for (const PictureOperator& one : list) names.insert(one.name), ++count;
    EXPECT_EQ(names.size(), count);
    EXPECT_GE(harmful_operators().size(), 30U);
}

TEST(PictureOperators, harmless_ones_move_few_levels_or_edge_pixels_only)
{
    const Image picture = disc();
    for (const PictureOperator& one : harmless_operators()) {
        EXPECT_FALSE(one.harmful);
        Random random(3);
        const auto changed = one.apply(picture, random);
        ASSERT_TRUE(changed) << one.name;
        EXPECT_NE(changed->cells, picture.cells) << one.name;
        // No pixel has a colour that neither it nor a neighbour had, give or take three levels.
        for (int y = 1; y < 159; ++y)
            for (int x = 1; x < 159; ++x) {
                int least = 255;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        int most = 0;
                        for (glm::length_t c = 0; c < 3; ++c)
                            most = std::max(most,
                                            std::abs(int{changed->at(x, y)[c]} - int{picture.at(x + dx, y + dy)[c]}));
                        least = std::min(least, most);
                    }
                ASSERT_LE(least, 3) << one.name << " at " << x << ", " << y;
            }
    }
}

TEST(PictureOperators, harmful_ones_show)
{
    const Image picture = disc();
    for (const PictureOperator& one : harmful_operators()) {
        EXPECT_TRUE(one.harmful);
        Random random(4);
        const auto changed = one.apply(picture, random);
        ASSERT_TRUE(changed) << one.name;
        EXPECT_FALSE(looks_the_same(to_picture(*changed), to_picture(picture))) << one.name;
    }
}

TEST(PictureOperators, are_handed_on_with_the_same_numbers_every_time)
{
    std::vector<std::vector<std::uint8_t>> first;
    std::vector<std::vector<std::uint8_t>> second;
    for (auto* pictures : {&first, &second})
        visit_operators("scene", to_picture(disc()),
                        [&](const PicturePair& pair) { pictures->push_back(pair.student.planes); });
    EXPECT_EQ(first, second);
    EXPECT_EQ(first.size(), harmless_operators().size() + harmful_operators().size());
}

TEST(PictureRules, all_are_zero_for_equal_pictures_and_grow_with_the_error)
{
    const Picture right = to_picture(disc());
    const auto measures_at = [&](int by) {
        const Picture student = to_picture(
            with_tones(disc(), [by](double level) { return level + (static_cast<int>(level) % 2 == 0 ? by : -by); }));
        return measure_by_rules(student, right, our_measure(student, right, false));
    };
    const PictureMeasures none = measures_at(0);
    const PictureMeasures some = measures_at(4);
    const PictureMeasures many = measures_at(40);
    for (std::size_t i = 0; i < picture_rules.size(); ++i) {
        EXPECT_NEAR(none[i], 0, 1e-12) << picture_rules[i].name;
        EXPECT_GE(some[i], none[i]) << picture_rules[i].name;
        EXPECT_GT(many[i], some[i]) << picture_rules[i].name;
    }
}

TEST(PictureRules, gradient_deviation_ignores_a_constant_and_sees_a_line)
{
    const Picture right = to_picture(Image(64, 64, glm::u8vec4(100, 100, 100, 255)));
    EXPECT_NEAR(gradient_deviation(to_picture(Image(64, 64, glm::u8vec4(140, 140, 140, 255))), right), 0, 1e-12);
    Image line(64, 64, glm::u8vec4(100, 100, 100, 255));
    for (int x = 0; x < 64; ++x) line.at(x, 30) = line.at(x, 31) = glm::u8vec4(255, 255, 255, 255);
    // Two of 32 rows of gradients differ: their similarity is c / (g^2 + c) with g = 155, the rest is 1.
    const double low = 170 / (155.0 * 155.0 + 170);
    const double mean = (30 + 2 * low) / 32;
    EXPECT_NEAR(gradient_deviation(to_picture(line), right), std::sqrt((30 + 2 * low * low) / 32 - mean * mean), 1e-9);
}

TEST(PictureRules, three_by_three_takes_the_better_direction)
{
    Image lines(64, 64, glm::u8vec4(0, 0, 0, 255));
    for (int y = 0; y < 64; ++y) lines.at(20, y) = glm::u8vec4(255, 255, 255, 255);
    const Picture one = to_picture(lines);
    const Picture blank = to_picture(Image(64, 64, glm::u8vec4(0, 0, 0, 255)));
    EXPECT_EQ(fuzzy_share(blank, one), 0) << "a missing thin line passes: why the larger direction decides in our rule";
    EXPECT_GT(our_measure(blank, one, false).worst, 1);
}

}
}
