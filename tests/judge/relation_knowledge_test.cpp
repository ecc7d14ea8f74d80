#include <gtest/gtest.h>

#include <algorithm>

#include "judge/explain/likeness.hpp"
#include "related.hpp"

// Recordings that agree with each other, as laws demand, but know nothing.
namespace umbral::grader::test {
namespace {

Tensor noise_picture(std::uint64_t seed)
{
    Random random(seed);
    return picture(128, 128, [&](int, int) {
        return Colour{random.below(256), random.below(256), random.below(256), 255};
    });
}

TEST(Relation, every_control_gets_nothing)
{
    const Recorded pictures = right_pictures();
    const Recorded shifted{balls_moved(3, 5), scene()};
    const Recorded fragments{triangle(0, 33, 45), triangle(0, 30, 40)};
    Random random(5);
    std::vector<float> kept;
    const Tensor to = random_table(random, 64, 1, &kept);
    const Recorded doubled{random_table(random, 64, 2, &kept), to};
    const std::vector<std::pair<Check, const Recorded*>> all = {
        {with_relation(JudgeKind{"image"}, equal()), &pictures},
        {with_relation(JudgeKind{"image"}, moved(3, 5)), &shifted},
        {with_relation(JudgeKind{"fragments"}, moved(3, 5)), &fragments},
        {with_relation(JudgeKind{"numbers"}, times(2), relative(1e-5)), &doubled}};
    for (const auto& [check, run] : all)
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const RelationJudge law(check, run->tensors(), nullptr, seed);
            EXPECT_GE(law.controls().size(), 5U);
            for (const RelatedControl& control : law.controls())
                EXPECT_EQ(law.judge(control.tensors()).right, 0)
                    << to_string(check.judge) << ": " << control.name << ", seed " << seed;
            EXPECT_EQ(law.best_control().right, 0);
            EXPECT_EQ(law.judge(run->tensors()).right, 1) << "and the reference all";
        }
}

TEST(Relation, pictures_that_know_nothing_get_nothing_however_well_they_agree)
{
    const Check same = with_relation(JudgeKind{"image"}, equal());
    const Check along = with_relation(JudgeKind{"image"}, moved(3, 5));
    const Recorded reference{balls_moved(3, 5), scene()};
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Tensor noise = noise_picture(seed);
        const auto moved_noise = expected_by_relation(along, noise, noise);
        EXPECT_EQ(right(same, {noise, noise, noise_picture(seed + 100)}, right_pictures()), 0)
            << "one noise under both names, another under the third";
        EXPECT_EQ(right(along, {*moved_noise, noise}, reference), 0) << "noise that moves";
        EXPECT_EQ(right(same, {noise, noise_picture(seed + 50), mirrored()}, right_pictures()), 0)
            << "noise is not equal to other noise";
    }
    EXPECT_EQ(right(same, {scene(), scene(), scene()}, right_pictures()), 0) << "the same picture whatever is asked";
    EXPECT_EQ(right(along, {scene(), scene()}, reference), 0) << "the same picture, unmoved";
    const Tensor one_pixel = repaint(scene(), [](int x, int y) {
        return x == 40 && y == 50 ? Colour{255, 255, 255, 255} : night;
    });
    const Tensor moved_pixel = repaint(scene(), [](int x, int y) {
        return x == 43 && y == 55 ? Colour{255, 255, 255, 255} : night;
    });
    EXPECT_EQ(right(along, {moved_pixel, one_pixel}, reference), 0) << "too little of it";
}

TEST(Relation, a_message_says_why_agreement_is_not_enough)
{
    const Judgement found =
        RelationJudge(with_relation(JudgeKind{"image"}, equal()), right_pictures().tensors(), nullptr, 1)
            .judge({&scene(), &scene(), &scene()});
    EXPECT_EQ(found.right, 0);
    EXPECT_NE(found.message.find("your 'turned'"), std::string::npos) << found.message;
}

TEST(Likeness, is_high_for_work_and_low_for_noise)
{
    const Check check = check_of(JudgeKind{"image"});
    EXPECT_DOUBLE_EQ(*likeness(check, scene(), scene()), 1);
    EXPECT_GT(*likeness(check, gamma_twice(scene()), scene()), 0.7);
    EXPECT_LT(*likeness(check, mirrored(), scene()), 0.5);
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        EXPECT_LT(*likeness(check, noise_picture(seed), scene()), 0.05) << "seed " << seed;
    EXPECT_EQ(*likeness(check, picture(128, 128, [](int, int) { return night; }), scene()), 0);
    const Tensor mask = optional_floats(std::vector<float>(40, 0), [] {
        std::vector<std::uint8_t> present(40, 0);
        std::fill_n(present.begin(), 20, std::uint8_t{1});
        return present;
    }());
    EXPECT_EQ(*likeness(check_of(JudgeKind{"numbers"}), mask, mask), 1) << "what is there is knowledge too";
    EXPECT_EQ(*likeness(check_of(JudgeKind{"numbers"}),
                        optional_floats(std::vector<float>(40, 0), std::vector<std::uint8_t>(40, 1)), mask),
              0.5);
}

}
}
