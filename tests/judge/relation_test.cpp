#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "related.hpp"

namespace umbral::grader::test {
namespace {

TEST(Relation, any_right_recording_has_it_all)
{
    EXPECT_EQ(right(with_relation(JudgeKind{"image"}, equal()), right_pictures(), right_pictures()), 1);
    for (const auto& [x, y] : {std::pair(3, 5), std::pair(-7, 2), std::pair(0, -20), std::pair(40, 0)}) {
        const Recorded run{balls_moved(x, y), scene()};
        EXPECT_EQ(right(with_relation(JudgeKind{"image"}, moved(x, y)), run, run), 1) << x << ", " << y;
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        std::vector<float> kept;
        const Tensor to = random_table(random, 40, 1, &kept);
        const double factor = random.uniform(0.1F, 0.8F) * (seed % 2 == 0 ? 10 : 1);
        const Recorded run{random_table(random, 40, factor, &kept), to};
        EXPECT_EQ(right(with_relation(JudgeKind{"numbers"}, times(factor), ulps(4)), run, run, seed), 1)
            << "seed " << seed;
    }
    const Recorded fragments{triangle(0, 33, 45), triangle(0, 30, 40)};
    EXPECT_EQ(right(with_relation(JudgeKind{"fragments"}, moved(3, 5)), fragments, fragments), 1);
}

TEST(Relation, what_is_wrong_in_the_same_way_everywhere_still_has_it)
{
    const Recorded wrong{gamma_twice(scene()), gamma_twice(scene()), gamma_twice(mirrored())};
    EXPECT_EQ(right(with_relation(JudgeKind{"image"}, equal()), wrong, right_pictures()), 1)
        << "no picture is right, and the law holds";
    EXPECT_LT(judge(check_of(JudgeKind{"image"}), wrong.value, scene(), nullptr).right, 0.5);
}

TEST(Relation, what_breaks_the_law_loses_it)
{
    const Check check = with_relation(JudgeKind{"image"}, equal());
    Recorded broken = right_pictures();
    broken.value = gamma_twice(scene());
    const Judgement found = RelationJudge(check, right_pictures().tensors(), nullptr, 1).judge(broken.tensors());
    EXPECT_LT(found.right, 0.5);
    EXPECT_EQ(found.message.rfind("Rotating scene and camera together must not change the picture. Expected here is "
                                  "your own 'upright'. The picture differs",
                                  0),
              0U)
        << found.message;
    EXPECT_TRUE(found.first_difference.has_value());
    const Recorded still{balls_moved(3, 4), scene()};
    const Recorded reference{balls_moved(3, 5), scene()};
    EXPECT_LT(right(with_relation(JudgeKind{"image"}, moved(3, 5)), still, reference), 0.8) << "one pixel too few";

    Random random(3);
    std::vector<float> kept;
    const Tensor to = random_table(random, 40, 1, &kept);
    const Recorded four{random_table(random, 40, 4, &kept), to};
    const Recorded two{random_table(random, 40, 2, &kept), to};
    EXPECT_EQ(right(with_relation(JudgeKind{"numbers"}, times(4), relative(1e-6)), two, four), 0)
        << "area grows with the square";
}

TEST(Relation, what_comes_in_from_outside_is_not_compared)
{
    Recorded run{balls_moved(9, -6), scene()};
    const Tensor clean = run.value;
    run.value = repaint(clean, [&](int x, int y) {
        return x < 9 || y >= 122 ? Colour{255, 0, 255, 255} : pixel(clean, x, y);
    });
    const Recorded reference{clean, scene()};
    EXPECT_EQ(right(with_relation(JudgeKind{"image"}, moved(9, -6)), run, reference), 1);
    run.value = repaint(clean, [&](int x, int y) { return x < 14 ? Colour{255, 0, 255, 255} : pixel(clean, x, y); });
    EXPECT_LT(right(with_relation(JudgeKind{"image"}, moved(9, -6)), run, reference), 0.5);
}

TEST(Relation, alpha_is_not_scaled)
{
    const Tensor to = floats({0.1F, 0.2F, 0.3F, 1}, 4);
    const auto twice = expected_by_relation(with_relation(JudgeKind{"image"}, times(2)), to, to);
    ASSERT_TRUE(twice.has_value());
    EXPECT_EQ(*twice, floats({0.2F, 0.4F, 0.6F, 1}, 4));
}

TEST(Relation, damaged_recordings_are_wrong_and_never_an_exception)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float huge = std::numeric_limits<float>::max();
    Random random(11);
    std::vector<float> kept;
    const Tensor to = random_table(random, 40, 1, &kept);
    const Recorded good{random_table(random, 40, 2, &kept), to};
    const Check check = with_relation(JudgeKind{"numbers"}, times(2), relative(1e-5));
    const RelationJudge law(check, good.tensors(), nullptr, 1);
    Tensor cut = good.to;
    cut.bytes.pop_back();
    const std::vector<Tensor> spoilt = {Tensor{},
                                        floats({}),
                                        floats({1, 2}),
                                        cut,
                                        doubles(std::vector<double>(40, 1)),
                                        floats(std::vector<float>(40, nan)),
                                        floats(std::vector<float>(40, huge)),
                                        optional_floats(std::vector<float>(40, 0), std::vector<std::uint8_t>(40, 0))};
    for (std::size_t i = 0; i < spoilt.size(); ++i) {
        EXPECT_EQ(law.judge({&spoilt[i], &good.to}).right, 0) << i;
        EXPECT_EQ(law.judge({&good.value, &spoilt[i]}).right, 0) << i;
        EXPECT_EQ(law.judge({&spoilt[i], &spoilt[i]}).right, 0) << i;
        EXPECT_FALSE(law.judge({&good.value, &spoilt[i]}).message.empty()) << i;
    }
    EXPECT_EQ(law.judge({&good.value, nullptr}).right, 0);
    EXPECT_EQ(law.judge({nullptr, &good.to}).right, 0);
    std::vector<float> one_nan = kept;
    one_nan[7] = nan;
    EXPECT_EQ(law.judge({&good.value, nullptr}).message, "Nothing was recorded as 'upright': the run was disturbed.");
    const Tensor with_nan = floats(one_nan);
    EXPECT_EQ(law.judge({&with_nan, &with_nan}).right, 0) << "nan is not twice nan";

    const Recorded fragments{triangle(0, 33, 45), triangle(0, 30, 40)};
    const RelationJudge places(with_relation(JudgeKind{"fragments"}, moved(3, 5)), fragments.tensors(), nullptr, 1);
    const std::vector<Tensor> bad = {Tensor{}, floats({}, 3), floats({1, 2}), floats(std::vector<float>(300, nan), 3),
                                     floats(std::vector<float>(300, 0.5F), 3)};
    for (const Tensor& tensor : bad) {
        EXPECT_EQ(places.judge({&tensor, &fragments.to}).right, 0);
        EXPECT_EQ(places.judge({&fragments.value, &tensor}).right, 0);
        EXPECT_EQ(places.judge({&tensor, &tensor}).right, 0);
    }
    const Recorded pictures = right_pictures();
    const RelationJudge image(with_relation(JudgeKind{"image"}, equal()), pictures.tensors(), nullptr, 1);
    const Tensor small = balls(64);
    EXPECT_EQ(image.judge({&small, &small, &small}).right, 0) << "another size";
}

TEST(Relation, one_that_tells_nothing_is_a_fault_of_the_unit)
{
    const auto fault = [](const Check& check, const Recorded& reference) {
        try {
            (void)RelationJudge(check, reference.tensors(), nullptr, 1);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("no fault");
    };
    const auto tells = [&](const Check& check, const Recorded& reference, const char* what) {
        EXPECT_NE(fault(check, reference).find(what), std::string::npos) << fault(check, reference);
    };
    tells(with_relation(JudgeKind{"image"}, equal()), {scene(), scene()}, "nothing called 'turned'");
    tells(with_relation(JudgeKind{"image"}, equal()), {scene(), scene(), scene()}, "almost like 'upright'");
    const Tensor flat = picture(64, 64, [](int, int) { return night; });
    tells(with_relation(JudgeKind{"image"}, moved(3, 5)), {flat, flat}, "the same everywhere");
    tells(with_relation(JudgeKind{"numbers"}, times(2), relative(0.1)), {floats({2, 4, 6}), floats({1, 2, 3})},
          "fewer than 32");
    tells(with_relation(JudgeKind{"buffer"}, times(2)),
          {grid(8, 8, std::vector<std::uint32_t>(64, 2)), grid(8, 8, std::vector<std::uint32_t>(64, 1))},
          "whole numbers");
    tells(with_relation(JudgeKind{"image"}, moved(3, 5)), {balls(64), scene()}, "another shape");
}

}
}
