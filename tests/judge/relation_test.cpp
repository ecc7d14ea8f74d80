#include "judge/relation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "judge/explain/likeness.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {
Check with_relation(JudgeKind kind, const Relation& relation, Tolerance tolerance = {})
{
    Check check = check_of(kind, tolerance);
    check.value = "value";
    check.relation = relation;
    return check;
}

Relation equal()
{
    return {"upright", "turned", {0, 0}, 1, "rotating scene and camera together must not change the picture"};
}
Relation moved(int x, int y)
{
    return {"upright", "", {x, y}, 1, "a window further right must show the same picture there"};
}
Relation times(double factor) { return {"upright", "", {0, 0}, factor, "twice the light must be twice as bright"}; }

/// What one run recorded, with copies that tests may spoil.
struct Recorded {
    Tensor value;
    Tensor to;
    Tensor unlike{};

    [[nodiscard]] RelatedTensors tensors() const { return {&value, &to, unlike.cells() > 0 ? &unlike : nullptr}; }
};

double right(const Check& check, const Recorded& student, const Recorded& reference, std::uint64_t seed = 1)
{
    return RelationJudge(check, reference.tensors(), nullptr, seed).judge(student.tensors()).right;
}

constexpr Colour night{8, 10, 40, 255};

/// The two balls `dx` and `dy` pixels further; beyond the border is sky.
Tensor balls_moved(int dx, int dy)
{
    return repaint(scene(), [&](int x, int y) {
        const int from_x = x - dx;
        const int from_y = y - dy;
        return from_x < 0 || from_y < 0 || from_x >= 128 || from_y >= 128 ? night : pixel(scene(), from_x, from_y);
    });
}

Tensor mirrored()
{
    return repaint(scene(), [](int x, int y) { return pixel(scene(), 127 - x, y); });
}

Tensor noise_picture(std::uint64_t seed)
{
    Random random(seed);
    return picture(128, 128, [&](int, int) {
        return Colour{random.below(256), random.below(256), random.below(256), 255};
    });
}

Tensor gamma_twice(const Tensor& of)
{
    return repaint(of, [&](int x, int y) {
        Colour colour = pixel(of, x, y);
        for (glm::length_t c = 0; c < 3; ++c) colour[c] = byte(255 * std::pow(colour[c] / 255.0, 1 / 2.2));
        return colour;
    });
}

Recorded right_pictures() { return {scene(), scene(), mirrored()}; }

Tensor random_table(Random& random, std::uint32_t rows, double factor = 1, std::vector<float>* kept = nullptr)
{
    std::vector<float> values;
    for (std::uint32_t i = 0; i < rows; ++i)
        values.push_back(kept != nullptr && !kept->empty() ? static_cast<float>(factor) * (*kept)[i]
                                                           : random.uniform(1, 9));
    if (kept != nullptr && kept->empty()) *kept = values;
    return floats(values);
}

Tensor triangle(int primitive, int x0, int y0)
{
    std::vector<float> rows;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x <= y; ++x)
            rows.insert(rows.end(),
                        {static_cast<float>(primitive), static_cast<float>(x0 + x), static_cast<float>(y0 + y)});
    return floats(rows, 3);
}

TEST(Relation, AnyRightRecordingHasItAll)
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

TEST(Relation, WhatIsWrongInTheSameWayEverywhereStillHasIt)
{
    const Recorded wrong{gamma_twice(scene()), gamma_twice(scene()), gamma_twice(mirrored())};
    EXPECT_EQ(right(with_relation(JudgeKind{"image"}, equal()), wrong, right_pictures()), 1)
        << "no picture is right, and the law holds";
    EXPECT_LT(judge(check_of(JudgeKind{"image"}), wrong.value, scene(), nullptr).right, 0.5);
}

TEST(Relation, WhatBreaksTheLawLosesIt)
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

TEST(Relation, WhatComesInFromOutsideIsNotCompared)
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

TEST(Relation, AlphaIsNotScaled)
{
    const Tensor to = floats({0.1F, 0.2F, 0.3F, 1}, 4);
    const auto twice = expected_by_relation(with_relation(JudgeKind{"image"}, times(2)), to, to);
    ASSERT_TRUE(twice.has_value());
    EXPECT_EQ(*twice, floats({0.2F, 0.4F, 0.6F, 1}, 4));
}

TEST(Relation, EveryControlGetsNothing)
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

TEST(Relation, PicturesThatKnowNothingGetNothingHoweverWellTheyAgree)
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

TEST(Relation, AMessageSaysWhyAgreementIsNotEnough)
{
    const Judgement found =
        RelationJudge(with_relation(JudgeKind{"image"}, equal()), right_pictures().tensors(), nullptr, 1)
            .judge({&scene(), &scene(), &scene()});
    EXPECT_EQ(found.right, 0);
    EXPECT_NE(found.message.find("your 'turned'"), std::string::npos) << found.message;
}

TEST(Relation, DamagedRecordingsAreWrongAndNeverAnException)
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

TEST(Relation, OneThatTellsNothingIsAFaultOfTheUnit)
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

TEST(Likeness, IsHighForWorkAndLowForNoise)
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
