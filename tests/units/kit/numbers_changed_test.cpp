#include <gtest/gtest.h>

#include <kit/numbers_changed.hpp>

namespace umbral {
namespace {

struct Lamp {
    glm::vec3 place{0};
    float power = 1;
};

struct Look {
    std::vector<Lamp> lamps;
    glm::mat4 view{1};
    float width = 1;
    bool open = true;
};

std::vector<float> numbers_of(Look look)
{
    std::vector<detail::NumberPlace> places;
    detail::add_numbers(look, places);
    std::vector<float> all;
    for (const detail::NumberPlace& place : places) all.push_back(*place.number);
    return all;
}

Look random_look(Random& random)
{
    Look look;
    look.lamps = {{random.in_cube(), random.uniform(0.5F, 9)}, {random.in_cube(), random.uniform(0.5F, 9)}};
    look.width = random.uniform(2, 9);
    return look;
}

bool is_allowed(const Look& look) { return look.width >= 0.5F && look.lamps[0].power > 0 && look.lamps[1].power > 0; }

TEST(NumbersChanged, each_question_differs_from_the_one_before_in_one_number)
{
    constexpr std::uint64_t seed = 1207;
    Random random(seed);
    std::vector<std::size_t> changes(9);
    std::size_t zeros = 0;
    std::size_t small = 0;
    std::size_t equal = 0;
    for (int i = 0; i < 200; ++i) {
        const auto all = numbers_changed(random, random_look(random), 20, is_allowed);
        ASSERT_EQ(all.size(), 10U) << "the first, and one for each of its nine numbers; seed " << seed;
        for (std::size_t k = 1; k < all.size(); ++k) {
            ASSERT_TRUE(is_allowed(all[k]));
            const std::vector<float> before = numbers_of(all[k - 1]);
            const std::vector<float> after = numbers_of(all[k]);
            std::size_t differing = 0;
            for (std::size_t n = 0; n < after.size(); ++n)
                if (before[n] != after[n]) {
                    ++differing;
                    ++changes[n];
                    zeros += after[n] == 0 ? 1U : 0U;
                    small += after[n] > 0 && after[n] < 1 ? 1U : 0U;
                }
            ASSERT_EQ(differing, 1U) << "question " << k << ", seed " << seed;
        }
        const glm::vec3 place = all.back().lamps[0].place;
        equal += place.x == place.y || place.y == place.z || place.x == place.z ? 1U : 0U;
    }
    for (std::size_t n = 0; n < changes.size(); ++n) EXPECT_EQ(changes[n], 200U) << "number " << n;
    EXPECT_GT(zeros, 200U);
    EXPECT_GT(small, 200U);
    EXPECT_GT(equal, 50U);
}

TEST(NumbersChanged, stop_at_the_number_asked_for_and_leave_out_what_is_not_allowed)
{
    Random random(3);
    EXPECT_EQ(numbers_changed(random, random_look(random), 4, is_allowed).size(), 5U);
    EXPECT_EQ(numbers_changed(random, random_look(random), 4, [](const Look&) { return false; }).size(), 1U);
    const std::tuple<glm::vec3, float> arguments({1, 2, 3}, 4.0F);
    EXPECT_EQ(numbers_changed(random, arguments, 9, [](const auto&) { return true; }).size(), 5U);
}

}
}
