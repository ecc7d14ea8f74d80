#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <umbral/record/case.hpp>
#include <vector>

// Inputs that are written down in drivers: as written at a desk, others where they are asked for.
namespace umbral {
namespace {

constexpr std::uint64_t plain_seed = 0x1234;
constexpr std::uint64_t varied_seed = VariedSeed::with_mark(0x1234);

TEST(VariedSeed, is_marked_in_its_upper_bits_alone)
{
    EXPECT_TRUE(VariedSeed::is(varied_seed));
    EXPECT_EQ(varied_seed & 0xFFFFFFFFFFFFU, plain_seed);
    EXPECT_FALSE(VariedSeed::is(plain_seed));
    EXPECT_EQ(VariedSeed::without_mark(plain_seed), plain_seed);
    EXPECT_FALSE(VariedSeed::is(VariedSeed::without_mark(varied_seed)));
    constexpr std::uint64_t all_but_one = VariedSeed::mark & ~(std::uint64_t{1} << 50U);
    EXPECT_FALSE(VariedSeed::is(all_but_one));
    EXPECT_EQ(VariedSeed::without_mark(all_but_one), all_but_one);
}

TEST(Variation, gives_what_is_written_unless_it_is_asked_for)
{
    for (Variation vary : {Variation(), Variation(plain_seed)}) {
        EXPECT_FALSE(vary);
        EXPECT_EQ(vary.random(), nullptr);
        EXPECT_EQ(vary.near(3.25, 1.0), 3.25);
        EXPECT_EQ(vary.near(-3, 1), -3);
        EXPECT_EQ(vary.near(glm::vec3(1, 2, 3), 1.0F), glm::vec3(1, 2, 3));
        EXPECT_EQ(vary.scaled(7.0F, 3), 7.0F);
        EXPECT_EQ(vary.one_of(1, std::array{2, 3}), 1);
        EXPECT_EQ(vary.turn({0, 0, 1}, 1), glm::mat3(1));
        const ExactMap map = vary.exact_map();
        EXPECT_EQ(map.place({1, 2, 3}), glm::vec3(1, 2, 3));
        EXPECT_EQ(map.scale(), 1);
    }
}

TEST(Variation, keeps_to_what_it_is_told)
{
    Variation vary(varied_seed);
    ASSERT_TRUE(vary);
    std::set<int> integers;
    std::set<double> numbers;
    for (int i = 0; i < 300; ++i) {
        integers.insert(vary.near(10, 2));
        const double number = vary.near(10.0, 2.0);
        EXPECT_LE(std::abs(number - 10), 2);
        numbers.insert(number);
        const glm::vec3 scaled = vary.scaled(glm::vec3(1, 2, -4), 2);
        EXPECT_GE(scaled.x, 0.5F);
        EXPECT_LE(scaled.x, 2.0F);
        EXPECT_EQ(scaled.y, 2 * scaled.x);
        EXPECT_EQ(scaled.z, -4 * scaled.x);
        EXPECT_NE(vary.one_of(1, std::array{2, 3}), 1);
    }
    EXPECT_EQ(integers, (std::set<int>{8, 9, 10, 11, 12}));
    EXPECT_EQ(numbers.size(), 300U);
}

TEST(Variation, differs_from_seed_to_seed_and_is_the_same_for_one)
{
    const auto drawn = [](std::uint64_t seed) { return Variation(VariedSeed::with_mark(seed)).near(0.0, 1.0); };
    EXPECT_EQ(drawn(1), drawn(1));
    EXPECT_NE(drawn(1), drawn(2));
}

// What asks of nearly the same inputs beside a case.
TEST(Variation, of_few_leaves_most_as_written)
{
    Variation vary = Variation::of_few(7);
    ASSERT_TRUE(vary);
    int changed = 0;
    int random = 0;
    for (int i = 0; i < 4000; ++i) {
        changed += vary.near(3.25, 1.0) != 3.25 ? 1 : 0;
        random += vary.random() != nullptr ? 1 : 0;
    }
    EXPECT_NEAR(changed, 500, 90) << "four standard deviations";
    EXPECT_NEAR(random, 500, 90);
}

TEST(Random, with_slips_is_the_same_but_for_some_numbers)
{
    Random plain(5);
    Random slipping = Random::with_slips(5, 77);
    Random again = Random::with_slips(5, 77);
    std::vector<int> gaps;
    int gap = 0;
    for (int i = 0; i < 20'000; ++i) {
        const std::uint32_t number = slipping.bits();
        EXPECT_EQ(number, again.bits());
        ++gap;
        if (number == plain.bits()) continue;
        gaps.push_back(gap);
        gap = 0;
    }
    // Gaps of 1 to 48 and of 1 to 12 numbers by turns: of two together, 31 on average.
    EXPECT_NEAR(static_cast<double>(gaps.size()), 2 * 20'000 / 31.0, 130);
    EXPECT_GT(*std::ranges::max_element(gaps), 40);
    EXPECT_EQ(*std::ranges::min_element(gaps), 1);
}

TEST(ExactMap, turns_and_scales_without_rounding_and_never_leaves_all_in_place)
{
    std::set<std::string> turns;
    Variation vary(varied_seed);
    for (int i = 0; i < 2000; ++i) {
        const ExactMap map = vary.exact_map(3);
        glm::mat3 turn;
        for (int k = 0; k < 3; ++k) {
            glm::vec3 axis(0);
            axis[k] = 1;
            turn[k] = map.direction(axis);
        }
        EXPECT_EQ(glm::determinant(turn), 1.0F) << "triangles keep their winding";
        EXPECT_NE(turn, glm::mat3(1));
        const glm::vec3 p(0.1F, -3.7F, 1e-7F);
        EXPECT_EQ(map.place(p), map.scale() * (turn * p));
        EXPECT_EQ(map.place(p), map.matrix() * p);
        EXPECT_EQ(map.place(glm::vec4(p, 0.5F)), glm::vec4(map.place(p), 0.5F)) << "w remains";
        EXPECT_LE(std::abs(std::log2(map.scale())), 3);
        std::string text;
        for (int k = 0; k < 9; ++k) text += std::to_string(static_cast<int>(turn[k / 3][k % 3])) + ' ';
        turns.insert(text);
    }
    EXPECT_EQ(turns.size(), 23U);
}

}
}
