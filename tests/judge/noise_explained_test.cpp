#include <gtest/gtest.h>

#include "judge/explain/explain.hpp"
#include "judge/noise/noise.hpp"
#include "judge/picture/image_difference.hpp"
#include "noise_runs.hpp"

// What is said and shown of noise: words, maps, and mistakes that are known by it.
namespace umbral::grader::test {
namespace {

TEST(Noise, words_name_the_worst_place)
{
    Random random(seed);
    const Tensor expected = estimates(random);
    const Tensor names = text("0 The floor\n1 The wall\n2 The lamp\n3 The corner\n");
    Tensor lamp = expected;
    for (std::size_t row = 0; row < 400; ++row) {
        double value = 0;
        std::memcpy(&value, lamp.bytes.data() + (4 * row + 2) * sizeof value, sizeof value);
        value *= 0.9;
        std::memcpy(lamp.bytes.data() + (4 * row + 2) * sizeof value, &value, sizeof value);
    }
    const Judgement named = judge(check, lamp, expected, nullptr, &names);
    EXPECT_EQ(named.message.rfind("The lamp is 10 % too low on average over 400 rows", 0), 0U) << named.message;
    EXPECT_EQ(judge(check, lamp, expected, nullptr).message.rfind("Component 2 is 10 % too low", 0), 0U);
    ASSERT_TRUE(named.first_difference);
    EXPECT_EQ(named.first_difference->where, "The lamp, on average");
    EXPECT_TRUE(named.message.ends_with(". The 3 others are right.")) << named.message;
}

TEST(Noise, words_name_what_is_off_beside_the_worst)
{
    Random random(seed);
    const Tensor expected = estimates(random);
    const Tensor names = text("0 The floor\n1 The wall\n2 The lamp\n3 The corner\n");
    Tensor darker = expected;
    for (std::size_t row = 0; row < 400; ++row)
        for (const std::size_t component : {0U, 2U}) {
            double value = 0;
            std::memcpy(&value, darker.bytes.data() + (4 * row + component) * sizeof value, sizeof value);
            value *= component == 0 ? 0.75 : 0.5;
            std::memcpy(darker.bytes.data() + (4 * row + component) * sizeof value, &value, sizeof value);
        }
    const std::string message = judge(check, darker, expected, nullptr, &names).message;
    EXPECT_TRUE(message.ends_with("Of the 3 others 1 is off as well: the floor by -25 %.") ||
                message.ends_with("Of the 3 others 1 is off as well: the lamp by -50 %."))
        << message;
}

TEST(Noise, a_mistake_is_known_by_its_light)
{
    Random random(seed);
    const Tensor expected = run(random);
    const Tensor student = run(random, 2);
    const FailingCheck failing{&check, &student, &expected, nullptr};
    const auto says = [](const FailingCheck& one, const Tensor& mistake) { return resemblance(one, mistake).says; };
    EXPECT_EQ(says(failing, run(random, 2)), Says::for_it) << "other noise, the same light";
    EXPECT_EQ(says(failing, run(random, 0.5)), Says::against_it);
    EXPECT_EQ(says(failing, run(random)), Says::against_it) << "no mistake at all";
    const Tensor fine = run(random);
    EXPECT_EQ(says({&check, &fine, &expected, nullptr, false}, run(random, 2)), Says::against_it)
        << "the student passes what it would fail";
}

TEST(Noise, the_map_shows_means_and_no_noise)
{
    Random random(seed);
    const auto light = [](int, int) { return 0.2; };
    const Tensor expected = noisy(random, 64, 64, 1, 16, light);
    const Tensor student =
        noisy(random, 64, 64, 1, 16, [](int x, int y) { return x >= 32 && x < 48 && y >= 16 && y < 32 ? 0.6 : 0.2; });
    const Grid<std::uint8_t> map = difference_map(check, student, expected);
    EXPECT_NEAR(map.at(40, 20), 0.4 * 255, 8);
    EXPECT_EQ(map.at(32, 16), map.at(47, 31)) << "one level a tile";
    EXPECT_LT(map.at(10, 10), 5);
    const auto region = worst_region(check, student, expected);
    ASSERT_TRUE(region);
    EXPECT_EQ(map.at(region->peak_x, region->peak_y), map.at(40, 20));
    EXPECT_FALSE(worst_region(check, expected, expected));
}

}
}
