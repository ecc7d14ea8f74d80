#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <umbral/core/random.hpp>

#include "unit/evidence.hpp"
#include "worker/case_results.hpp"
#include "worker/related.hpp"

namespace umbral::grader::test {
namespace {

constexpr int side = 64;

/// A picture of floats from a function of the pixel, values 0 to 1.
template <class Paint>
Tensor painted(const Paint& paint)
{
    Tensor tensor{Element::float32, side, side, 3, {}, {}};
    tensor.bytes.resize(tensor.count() * sizeof(float));
    for (int i = 0; i < side * side * 3; ++i) {
        const float value = paint(i / 3 % side, i / 3 / side, i % 3);
        std::memcpy(tensor.bytes.data() + static_cast<std::size_t>(i) * sizeof(float), &value, sizeof value);
    }
    return tensor;
}

/// A shaded disc; `light` is its brightness.
Tensor disc(float x0, float y0, float light = 0.4F)
{
    return painted([=](int x, int y, int c) {
        const float dx = (static_cast<float>(x) - x0) / 14;
        const float dy = (static_cast<float>(y) - y0) / 14;
        const float inside = 1 - dx * dx - dy * dy;
        return inside <= 0 ? 0.0F : light * (0.3F + 0.5F * std::sqrt(inside) + 0.2F * static_cast<float>(c) * dx);
    });
}

Tensor noise(std::uint64_t seed)
{
    Random random(seed);
    return painted([&](int, int, int) { return random.uniform(0, 0.5F); });
}

RunOutcome run_of(std::map<std::string, Tensor> tensors)
{
    RunOutcome run;
    run.verdict = Verdict::ok;
    for (auto& [name, tensor] : tensors) run.recording.tensors.emplace(name, std::move(tensor));
    return run;
}

Check check(const Relation& relation)
{
    Check check;
    check.name = "laws/value";
    check.case_name = "laws";
    check.value = "value";
    check.judge = JudgeKind{"image"};
    check.points = 1000;
    check.relation = relation;
    return check;
}

const Check same = check({"upright", "turned", {0, 0}, 1, "turning all must change nothing"});
const Check moved = check({"upright", "", {5, -3}, 1, "moving the window must move the picture"});
const Check bright = check({"upright", "", {0, 0}, 2, "twice the light must be twice as bright"});

RunOutcome reference_of(const Check& check)
{
    const Tensor value = check.relation->moves() ? disc(35, 27) : disc(30, 30, check.relation->scales() ? 0.8F : 0.4F);
    return run_of({{"value", value}, {"upright", disc(30, 30)}, {"turned", disc(40, 22)}});
}

CheckResult grade(const Check& check, RunOutcome student)
{
    CaseResult one;
    one.student = std::move(student);
    const RunOutcome reference = reference_of(check);
    return judge_check(check, one, reference, reference);
}

TEST(RelationCheck, only_the_students_own_values_decide)
{
    for (const Check* each : {&same, &moved, &bright}) {
        EXPECT_EQ(grade(*each, reference_of(*each)).score, 1000) << each->relation->what;
        // All too dark by the same third: wrong, and as consistent as can be.
        const float dark = 0.27F;
        const Tensor value =
            each->relation->moves() ? disc(35, 27, dark) : disc(30, 30, each->relation->scales() ? 2 * dark : dark);
        EXPECT_EQ(
            grade(*each, run_of({{"value", value}, {"upright", disc(30, 30, dark)}, {"turned", disc(40, 22, dark)}}))
                .score,
            1000)
            << each->relation->what;
        // Right by the reference, but not by the law.
        RunOutcome broken = reference_of(*each);
        broken.recording.tensors["upright"] = disc(30, 30, dark);
        EXPECT_LT(grade(*each, broken).score, 500) << each->relation->what;
    }
}

// Whoever overwrites the recording can satisfy every law, and knows nothing all the same.
TEST(RelationCheck, a_hostile_recording_cannot_profit)
{
    for (const Check* each : {&same, &moved, &bright})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Tensor junk = noise(seed);
            const Tensor follows = *expected_by_relation(*each, junk, junk);
            const Tensor flat = painted([](int, int, int) { return 0.3F; });
            const Tensor other_flat = *expected_by_relation(*each, flat, flat);
            const Tensor corner = painted([](int x, int y, int) { return x < 8 && y < 8 ? 0.5F : 0.0F; });
            const Tensor far_corner = *expected_by_relation(*each, corner, corner);
            const std::vector<std::map<std::string, Tensor>> forged = {
                {{"value", follows}, {"upright", junk}, {"turned", noise(seed + 100)}},
                {{"value", junk}, {"upright", junk}, {"turned", junk}},
                {{"value", other_flat}, {"upright", flat}, {"turned", junk}},
                {{"value", far_corner}, {"upright", corner}, {"turned", flat}},
                {{"value", disc(30, 30)}, {"upright", disc(30, 30)}, {"turned", disc(30, 30)}},
                {{"value", follows}},
                {{"upright", junk}, {"turned", junk}},
                {}};
            for (std::size_t i = 0; i < forged.size(); ++i) {
                const CheckResult result = grade(*each, run_of(forged[i]));
                EXPECT_EQ(result.score, 0) << each->relation->what << ", forgery " << i << ", seed " << seed;
                EXPECT_FALSE(result.message.empty()) << "forgery " << i;
            }
        }
}

TEST(RelationCheck, a_driver_without_the_value_is_our_fault)
{
    RunOutcome reference = reference_of(same);
    reference.recording.tensors.erase("upright");
    CaseResult one;
    one.student = reference_of(same);
    EXPECT_THROW((void)judge_check(same, one, reference, reference), std::invalid_argument);
}

TEST(RelationCheck, reports_hold_up_the_students_other_value)
{
    const RunOutcome student =
        run_of({{"value", disc(35, 27)}, {"upright", disc(30, 30, 0.2F)}, {"turned", disc(40, 22)}});
    const ExpectedSide side_of_law = expected_side(moved, student, reference_of(moved));
    ASSERT_NE(side_of_law.tensor, nullptr);
    EXPECT_EQ(*side_of_law.tensor, *expected_by_relation(moved, disc(30, 30, 0.2F), disc(35, 27)));
    EXPECT_EQ(side_of_law.words, "your 'upright', changed");
    Check plain = moved;
    plain.relation.reset();
    const RunOutcome reference = reference_of(moved);
    EXPECT_EQ(expected_side(plain, student, reference).tensor.get(), tensor_of(reference, "value"));
    EXPECT_EQ(expected_side(plain, student, reference).words, "reference");
    EXPECT_EQ(expected_side(moved, run_of({{"value", disc(35, 27)}}), reference).tensor, nullptr);
    const Tensor broken = painted([](int, int, int) { return NAN; });
    EXPECT_EQ(expected_side(moved, run_of({{"value", disc(35, 27)}, {"upright", broken}}), reference).tensor, nullptr)
        << "nothing to hold up";
}

TEST(RelationCheck, is_explained_by_the_value_that_is_wrong)
{
    const RunOutcome reference = reference_of(moved);
    EXPECT_EQ(against_reference(moved, reference, reference).value, "value");
    EXPECT_EQ(
        against_reference(moved, run_of({{"value", disc(35, 27)}, {"upright", disc(30, 30, 0.2F)}}), reference).value,
        "upright");
    EXPECT_EQ(
        against_reference(moved, run_of({{"value", disc(30, 30)}, {"upright", disc(30, 30, 0.2F)}}), reference).value,
        "value");
    EXPECT_FALSE(against_reference(moved, reference, reference).relation.has_value());
}

}
}
