#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "judge/cost/cost.hpp"
#include "judge/evidence/kinds.hpp"
#include "judge/judges.hpp"
#include "judge/make.hpp"
#include "judge/rows/tensor_view.hpp"
#include "unit/evidence.hpp"

namespace umbral::grader {
namespace {

using test::floats;
using test::table;
using test::text;

Tensor grey(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& values)
{
    Tensor tensor = table(Element::uint8, 1, values);
    tensor.rows = height;
    tensor.columns = width;
    return tensor;
}

Check check(JudgeKind kind, double ulps = 4)
{
    Check made;
    made.name = "case/value";
    made.judge = kind;
    if (kind == JudgeKind{"numbers"} || kind == JudgeKind{"matrices"}) made.tolerance.ulps = ulps;
    return made;
}

template <class Kind>
Kind evidence(const Check& of, const Tensor& yours, const Tensor& expected, const Tensor* names = nullptr,
              bool right = false)
{
    const Evidence found = evidence_of(of, {&yours, &expected, nullptr, names}, right);
    EXPECT_TRUE(std::holds_alternative<Kind>(found));
    return std::holds_alternative<Kind>(found) ? std::get<Kind>(found) : Kind{};
}

bool is_nothing(const Evidence& found) { return std::holds_alternative<std::monostate>(found); }

TEST(Evidence, rows_mark_the_components_that_differ)
{
    const auto rows = evidence<RowsEvidence>(check(JudgeKind{"numbers"}), floats({1, 2, 3, 4, 5, 6}, 3),
                                             floats({1, 2, 3, 4, 7, 6}, 3));
    EXPECT_EQ(rows.rows, 2U);
    EXPECT_EQ(rows.wrong, 1U);
    ASSERT_EQ(rows.first.size(), 1U);
    EXPECT_EQ(rows.first[0].name, "row 1");
    EXPECT_EQ(rows.first[0].yours, (std::vector<std::string>{"4", "5", "6"}));
    EXPECT_EQ(rows.first[0].expected, (std::vector<std::string>{"4", "7", "6"}));
    EXPECT_EQ(rows.first[0].differs, (std::vector<bool>{false, true, false}));
}

TEST(Evidence, of_many_named_numbers_those_that_differ_are_shown)
{
    std::vector<float> right(20, 1);
    std::vector<float> wrong = right;
    wrong[9] = 2;
    wrong[13] = 3;
    const Tensor names = text("colour/4, width, rest/5");
    const auto rows = evidence<RowsEvidence>(check(JudgeKind{"numbers"}), floats(wrong, 10), floats(right, 10), &names);
    EXPECT_EQ(rows.headings, (std::vector<std::string>{"colour.a", "rest[4]"}));
    EXPECT_EQ(rows.equal_columns, 8U);
    EXPECT_EQ(rows.first.at(0).yours, (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(rows.first.at(1).yours, (std::vector<std::string>{"3", "1"}));
    EXPECT_EQ(rows.first.at(1).differs, (std::vector<bool>{true, false}));
    const Tensor others = text("no names that fit");
    EXPECT_TRUE(evidence<RowsEvidence>(check(JudgeKind{"numbers"}), floats(wrong, 10), floats(right, 10), &others)
                    .headings.empty());
}

TEST(Evidence, first_rows_then_the_worst_of_the_others)
{
    std::vector<float> wrong;
    std::vector<float> right;
    for (int i = 0; i < 100; ++i) right.push_back(100), wrong.push_back(101 + static_cast<float>(i));
    const auto rows = evidence<RowsEvidence>(check(JudgeKind{"numbers"}), floats(wrong), floats(right));
    EXPECT_EQ(rows.wrong, 100U);
    EXPECT_EQ(rows.first.front().name, "row 0");
    EXPECT_EQ(rows.worst.front().name, "row 99");
    EXPECT_LE(rows.first.size() + rows.worst.size(), 20U);
}

TEST(Evidence, digits_suffice_to_tell_numbers_apart)
{
    const auto pair_of = [](double yours, double expected) {
        return telling_apart(
            [&](int digits) { return std::pair(number_text(yours, digits), number_text(expected, digits)); });
    };
    EXPECT_EQ(pair_of(1, 1).first, "1");
    EXPECT_EQ(pair_of(0.1, 0.1).second, "0.1");
    EXPECT_EQ(pair_of(0.0, -0.0).second, "-0");
    const auto pair = pair_of(1.0000001, 1.0000002);
    EXPECT_NE(pair.first, pair.second);
    const double next = std::nextafter(0.1, 1);
    EXPECT_NE(pair_of(0.1, next).first, pair_of(0.1, next).second);
    EXPECT_EQ(pair_of(NAN, 1).first, "nan");
    EXPECT_EQ(pair_of(NAN, NAN).first, "nan") << "ends though NaN equals nothing";
}

TEST(Evidence, what_is_no_number_or_not_there_is_said)
{
    Tensor yours = floats({NAN, 2, 3});
    Tensor expected = floats({1, 2, 3});
    yours.present = {1, 0, 1};
    expected.present = {1, 1, 0};
    const auto rows = evidence<RowsEvidence>(check(JudgeKind{"numbers"}), yours, expected);
    ASSERT_EQ(rows.first.size(), 3U);
    EXPECT_EQ(rows.first[0].note, "not comparable");
    EXPECT_EQ(rows.first[1].yours, (std::vector<std::string>{"nothing"}));
    EXPECT_EQ(rows.first[1].note, "missing");
    EXPECT_EQ(rows.first[2].note, "nothing is expected");
}

TEST(Evidence, another_shape_gives_no_rows_but_both_pictures)
{
    EXPECT_TRUE(is_nothing(evidence_of(check(JudgeKind{"numbers"}), {}, false)));
    const Tensor three = floats({1, 2, 3});
    const Tensor two = floats({1, 2});
    EXPECT_TRUE(is_nothing(evidence_of(check(JudgeKind{"numbers"}), {&three, &two}, false)));
    const auto pictures = evidence<PictureEvidence>(check(JudgeKind{"image"}), grey(2, 1, {1, 2}), grey(1, 2, {1, 2}));
    EXPECT_FALSE(pictures.problem.empty());
    EXPECT_EQ(pictures.yours.width, 2);
    EXPECT_EQ(pictures.reference->width, 1);
}

TEST(Evidence, damaged_recordings_give_nothing)
{
    Tensor damaged = grey(4, 4, std::vector<std::uint8_t>(16, 1));
    const Tensor expected = damaged;
    damaged.bytes.resize(7);
    for (const JudgeRecord* judge : judges())
        EXPECT_TRUE(is_nothing(evidence_of(check(JudgeKind{std::string(judge->name)}), {&damaged, &expected}, false)))
            << judge->name;
}

TEST(Evidence, equal_pictures_are_shown_once)
{
    const auto pictures = evidence<PictureEvidence>(check(JudgeKind{"image"}), grey(2, 2, {1, 2, 3, 4}),
                                                    grey(2, 2, {1, 2, 3, 4}), nullptr, true);
    EXPECT_FALSE(pictures.yours.cells.empty());
    EXPECT_FALSE(pictures.reference.has_value());
}

TEST(Evidence, the_worst_pixels_come_with_their_values)
{
    std::vector<std::uint8_t> values(64 * 64, 10);
    const Tensor expected = grey(64, 64, values);
    values[40 * 64 + 50] = 200;
    values[41 * 64 + 51] = 11;
    const auto pictures = evidence<PictureEvidence>(check(JudgeKind{"image"}), grey(64, 64, values), expected);
    EXPECT_EQ(pictures.differing, 2U);
    EXPECT_EQ(pictures.largest, 190);
    ASSERT_TRUE(pictures.worst);
    ASSERT_EQ(pictures.pixels.size(), 2U);
    EXPECT_EQ(pictures.pixels[0].x, 50);
    EXPECT_EQ(pictures.pixels[0].y, 40);
    EXPECT_EQ(pictures.pixels[0].yours, "200");
    EXPECT_EQ(pictures.pixels[0].reference, "10");
    const Magnified& worst = *pictures.worst;
    const std::size_t place = static_cast<std::size_t>((40 - worst.y) * worst.yours.width + 50 - worst.x);
    EXPECT_EQ(worst.texts[worst.yours_texts[place]], "200");
    EXPECT_EQ(worst.texts[worst.reference_texts[place]], "10");
    EXPECT_EQ(worst.levels[place], 190);
}

TEST(Evidence, traces_are_aligned_and_equal_runs_fold)
{
    std::string expected = "glFlush\n";
    for (int i = 0; i < 30; ++i) expected += "glUniform1i 0 " + std::to_string(i) + "\n";
    std::string yours = expected;
    yours.replace(yours.find("glUniform1i 0 12\n"), 17, "");
    yours.replace(yours.find("glUniform1i 0 25\n"), 17, "glUniform1i 0 99\n");
    yours += "glFinish\n";
    const auto lines = evidence<LinesEvidence>(check(JudgeKind{"trace"}), text(yours), text(expected));
    EXPECT_EQ(lines.missing, 1U);
    EXPECT_EQ(lines.changed, 1U);
    EXPECT_EQ(lines.extra, 1U);
    std::size_t covered = 0;
    std::size_t folds = 0;
    for (const LinePair& line : lines.lines) {
        covered += line.kind == LineKind::omitted ? line.omitted : line.expected_number ? 1 : 0;
        folds += line.kind == LineKind::omitted ? 1 : 0;
        if (line.kind == LineKind::missing) {
            EXPECT_EQ(line.expected, "glUniform1i(0, 12)");
        }
        if (line.kind == LineKind::changed) {
            EXPECT_EQ(line.yours, "glUniform1i(0, 99)");
        }
    }
    EXPECT_EQ(covered, 31U) << "no expected line is lost";
    EXPECT_EQ(folds, 2U);
}

TEST(Evidence, an_endless_trace_is_cut_and_says_so)
{
    std::string endless;
    for (int i = 0; i < 60000; ++i) endless += "glFlush\n";
    const auto lines = evidence<LinesEvidence>(check(JudgeKind{"trace"}), text(endless), text("glClear 1\n"));
    EXPECT_TRUE(lines.cut);
    EXPECT_LE(lines.lines.size(), 200U);
}

TEST(Evidence, one_lost_event_is_one_lost_event)
{
    const Tensor names = text("1 press\n2 drag\n");
    const auto lines = evidence<LinesEvidence>(check(JudgeKind{"events"}), floats({1, 0, 2, 6, 2, 7}, 2),
                                               floats({1, 0, 2, 5, 2, 6, 2, 7}, 2), &names);
    EXPECT_EQ(lines.missing, 1U);
    EXPECT_EQ(lines.extra + lines.changed, 0U);
    EXPECT_EQ(lines.lines[1].expected, "drag (5)");
    const Tensor none{Element::float32, 0, 0, 1, {}, {}};
    EXPECT_EQ(evidence<LinesEvidence>(check(JudgeKind{"events"}), none, floats({1, 0}, 2)).missing, 1U)
        << "no event at all";
}

TEST(Evidence, fragments_are_counted_by_what_became_of_them)
{
    const auto found = evidence<FragmentsEvidence>(check(JudgeKind{"fragments"}),
                                                   floats({0, 1, 1, 5, 0, 2, 1, 9, 0, 7, 7, 1, 0, 1, 1, 5}, 4),
                                                   floats({0, 1, 1, 5, 0, 2, 1, 6, 0, 3, 1, 6}, 4));
    EXPECT_EQ(found.right, 1U);
    EXPECT_EQ(found.changed, 1U);
    EXPECT_EQ(found.missing, 1U);
    EXPECT_EQ(found.extra, 2U) << "one elsewhere, one twice";
    ASSERT_TRUE(found.picture);
    EXPECT_EQ(found.x, -1);
    EXPECT_EQ(found.picture->width, 7);
}

TEST(Evidence, fragments_far_away_take_no_memory)
{
    const auto found =
        evidence<FragmentsEvidence>(check(JudgeKind{"fragments"}), floats({0, 1e9F, -1e9F, NAN, INFINITY, 1}, 3),
                                    floats({0, -1e9F, 1e9F, 0, 1e9F, 0}, 3));
    ASSERT_TRUE(found.picture);
    EXPECT_LE(found.picture->width, 256);
}

TEST(Evidence, costs_pair_up_by_size)
{
    Check cost = check(JudgeKind{"cost"});
    cost.own = CostParameters{};
    const auto found = evidence<CostEvidence>(cost, table<double>(Element::float64, 2, {10, 100, 20, 400}),
                                              table<double>(Element::float64, 2, {10, 90, 20, 180, 40, 360}));
    ASSERT_EQ(found.points.size(), 3U);
    EXPECT_EQ(found.points[1].yours, 400);
    EXPECT_EQ(found.points[1].reference, 180);
    EXPECT_FALSE(found.points[2].yours);
}

TEST(Evidence, bounds_are_said_in_words)
{
    Check both = check(JudgeKind{"numbers"}, 16);
    both.tolerance.relative = 1e-6;
    EXPECT_EQ(describe(both).bound, "16 ulp, or 1e-06 relative");
    EXPECT_EQ(describe(both).limit, 16);
    EXPECT_TRUE(describe(check(JudgeKind{"image"})).bound.empty());
}

}
}
