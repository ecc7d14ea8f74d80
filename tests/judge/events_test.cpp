#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "explaining.hpp"
#include "judge/events/events.hpp"
#include "judge/rows/alignment.hpp"
#include "longest_alignment.hpp"

namespace umbral::grader::test {
namespace {

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

const Tensor& names()
{
    static const Tensor lines = text("1 press\n2 pan\n3 zoom in\nno line of these\n4\n");
    return lines;
}

Judgement judged(const std::vector<float>& yours, const std::vector<float>& expected, Tolerance tolerance = {})
{
    return judge(check_of(JudgeKind{"events"}, tolerance), floats(yours, 3), floats(expected, 3), nullptr, &names());
}

const std::vector<float> session{1, 0, 0, 2, 3, 0, 2, 4, 5, 3, 1.1F, 0, 1, 0, 0};

TEST(Events, equal_sequences_are_right)
{
    const Judgement found = judged(session, session);
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.message, "");
    EXPECT_FALSE(found.first_difference);
    EXPECT_EQ(found.metrics.at("matched"), 5);
}

TEST(Events, a_lost_event_costs_itself_only)
{
    std::vector<float> yours = session;
    yours.erase(yours.begin() + 9, yours.begin() + 12);
    const Judgement found = judged(yours, session);
    EXPECT_DOUBLE_EQ(found.right, 2.0 * 4 / (4 + 5));
    EXPECT_EQ(found.metrics.at("lost"), 1);
    EXPECT_EQ(found.message, "row 3: expected zoom in (1.1), nothing came (4 of 5 expected events are right)");
    EXPECT_EQ(found.first_difference->where, "row 3 of 5 events");
    EXPECT_EQ(found.first_difference->yours, "nothing");
    EXPECT_EQ(found.first_difference->expected, "zoom in (1.1)");
}

TEST(Events, are_clearly_wrong_where_no_rounding_explains_them)
{
    const auto clearly_wrong = [](float factor, const Tolerance& tolerance) {
        std::vector<float> yours = session;
        yours[10] = factor;
        return judged(yours, session, tolerance).clearly_wrong;
    };
    EXPECT_EQ(clearly_wrong(1.1F, absolute(0.01)), 0U);
    EXPECT_EQ(clearly_wrong(1.15F, absolute(0.01)), 0U) << "wrong, but by less than eight times the bound";
    EXPECT_EQ(clearly_wrong(1.2F, absolute(0.01)), 2U) << "one came for another";
    EXPECT_EQ(clearly_wrong(nan_f, absolute(0.01)), 2U);
    EXPECT_EQ(clearly_wrong(1.2F, {}), 2U);
    std::vector<float> lost = session;
    lost.resize(lost.size() - 3);
    EXPECT_EQ(judged(lost, session, absolute(0.01)).clearly_wrong, 1U);
}

TEST(Events, what_came_too_early_too_late_or_too_often_is_said_so)
{
    // press, pan (3, 0), pan (4, 5), zoom in, press
    const auto order = [&](std::initializer_list<int> places) {
        std::vector<float> yours;
        for (const int place : places) yours.insert(yours.end(), &session[3 * place], &session[3 * place] + 3);
        const std::string message = judged(yours, session).message;
        return message.substr(0, message.rfind(" ("));
    };
    EXPECT_EQ(order({3, 0, 1, 2, 4}), "row 0: zoom in (1.1) came too early: it is expected in row 3");
    EXPECT_EQ(order({0, 2, 3, 4, 1}), "row 1: expected pan (3, 0), nothing came; it came too late, in row 4 of yours");
    EXPECT_EQ(order({0, 1, 2, 1, 3, 4}), "row 3: pan (3, 0) came too often");
}

// "nothing" is said of what is expected nowhere, or came nowhere.
TEST(Events, what_is_known_to_the_other_side_is_said_to_be)
{
    const auto texts = [&](std::initializer_list<int> places) {
        std::vector<float> yours;
        for (const int place : places) yours.insert(yours.end(), &session[3 * place], &session[3 * place] + 3);
        const Difference first = *judged(yours, session).first_difference;
        return first.yours + " / " + first.expected;
    };
    EXPECT_EQ(texts({0, 1, 2, 1, 3, 4}), "pan (3, 0), twice / the same, once");
    EXPECT_EQ(texts({3, 0, 1, 2, 4}), "zoom in (1.1) / the same in row 3");
    EXPECT_EQ(texts({0, 2, 3, 4, 1}), "the same in row 4 / pan (3, 0)");
    EXPECT_EQ(texts({0, 1, 2, 3}), "the same, once / press, twice");
    std::vector<float> other = session;
    other.insert(other.end(), {2, 9, 9});
    EXPECT_EQ(judged(other, session).first_difference->expected, "nothing");
}

TEST(Events, numbers_are_shown_with_their_names)
{
    const Tensor named = text("3 zoom: centre/2\n2 pan: from, -\n1 press: a, b, c\n");
    const auto first = [&](std::size_t place, float value) {
        std::vector<float> yours = session;
        yours[place] = value;
        return *judge(check_of(JudgeKind{"events"}), floats(yours, 3), floats(session, 3), nullptr, &named)
                    .first_difference;
    };
    EXPECT_EQ(first(10, 2).yours, "zoom (centre 2 0)");
    EXPECT_EQ(first(10, 2).expected, "zoom (centre 1.1 0)");
    EXPECT_EQ(first(4, 7).yours, "pan (from 7)");
    EXPECT_EQ(first(1, 7).yours, "press: a, b, c (7)") << "names that do not fit the numbers belong to the event";
}

// Of two that differ in one of many numbers, that one is shown.
TEST(Events, of_long_ones_what_is_equal_is_left_out)
{
    const Tensor named = text(
        "1 object: name, origin/3, ambient/3, diffuse/3, specular/3, shininess\n2 end: a, b/3, c/3, d/3, e/3, f\n");
    const std::vector<float> right{1, 10, 0, 1, 2, .1F, .1F, .1F, .8F, .8F, .8F, 0, 0, 0, 4};
    const auto first = [&](std::size_t at, float value) {
        std::vector<float> yours = right;
        yours[at] = value;
        return *judge(check_of(JudgeKind{"events"}), floats(yours, 15), floats(right, 15), nullptr, &named)
                    .first_difference;
    };
    EXPECT_EQ(first(11, 0.8F).yours, "object (name 10, …, specular 0.8 0 0, …)");
    EXPECT_EQ(first(11, 0.8F).expected, "object (name 10, …, specular 0 0 0, …)");
    EXPECT_EQ(first(1, 11).yours, "object (name 11, …)");
    EXPECT_EQ(first(14, std::nextafter(4.0F, 5.0F)).expected, "object (name 10, …, shininess 4)");
    EXPECT_EQ(first(0, 2).expected,
              "object (name 10, origin 0 1 2, ambient 0.1 0.1 0.1, diffuse 0.8 0.8 0.8, specular 0 0 0, shininess 4)");
}

TEST(Events, columns_have_names_where_all_kinds_agree)
{
    using Names = std::vector<std::string>;
    EXPECT_EQ(event_columns("1 draw: heard, session\n2 update: heard, session\n3 end\n", 3),
              (Names{"the kind of event", "heard", "session"}));
    EXPECT_EQ(event_columns("1 pan: heard, session\n2 zoom: factor, session\n", 3), Names{});
    EXPECT_EQ(event_columns("1 pan\n", 3), Names{});
}

TEST(Events, two_different_numbers_never_look_alike)
{
    std::vector<float> yours = session;
    yours[4] = std::nextafter(3.0F, 4.0F);
    const Judgement found = judged(yours, session);
    EXPECT_NE(found.first_difference->yours, found.first_difference->expected);
    EXPECT_EQ(found.first_difference->expected, "pan (3, 0)");
}

TEST(Events, a_duplicate_or_another_event_is_named)
{
    std::vector<float> twice = session;
    twice.insert(twice.begin() + 3, {1, 0, 0});
    const Judgement again = judged(twice, session);
    EXPECT_DOUBLE_EQ(again.right, 2.0 * 5 / (6 + 5));
    EXPECT_EQ(again.message.substr(0, again.message.find(" (5")), "row 1: press came once more");
    EXPECT_FALSE(again.first_difference->cell) << "neither row beside it led to it";

    const Judgement once = judged(session, twice);
    EXPECT_EQ(once.message.substr(0, once.message.find(" (5")), "row 1: expected press: 3 of them in all, 2 came");

    std::vector<float> other = session;
    other[9] = 2;
    other[10] = 3;
    EXPECT_EQ(judged(other, session).message.substr(0, 57),
              "row 3: expected zoom in (1.1), pan (3, 0) came instead (4");
    std::vector<float> behind = session;
    behind.insert(behind.end(), {9, 0, 7});
    EXPECT_NE(judged(behind, session).message.find("row 5: event of code 9 (0, 7) came, and is expected nowhere"),
              std::string::npos);
    EXPECT_NE(judged({}, session).message.find("row 0: expected press, nothing came"), std::string::npos);
}

TEST(Events, the_tolerance_holds_for_numbers_not_for_codes)
{
    EXPECT_EQ(judged({3, 1.14F, 0}, {3, 1.1F, 0}, absolute(0.05)).right, 1);
    EXPECT_EQ(judged({3, 1.16F, 0}, {3, 1.1F, 0}, absolute(0.05)).right, 0);
    EXPECT_EQ(judged({3.01F, 1.1F, 0}, {3, 1.1F, 0}, absolute(0.05)).right, 0);
    EXPECT_EQ(judged({3, 1.1F, 0}, {3, std::nextafter(1.1F, 2.0F), 0}).right, 0);
}

TEST(Events, hostile_ones_match_nothing)
{
    const Judgement found = judged({nan_f, 0, 0, 2, nan_f, 0, 1, std::numeric_limits<float>::infinity(), 0},
                                   {1, 0, 0, 2, 3, 0}, absolute(1e9));
    EXPECT_EQ(found.right, 0);
    EXPECT_NE(found.message.find("an event whose code is no number"), std::string::npos) << found.message;
    EXPECT_THROW((void)judged({1, 0, 0}, {1, nan_f, 0}), std::invalid_argument);
    EXPECT_EQ(judge(check_of(JudgeKind{"events"}), floats({1, 2}, 2), floats({1, 2, 3}, 3), nullptr).right, 0);
    EXPECT_EQ(judge(check_of(JudgeKind{"events"}), Tensor{}, floats({1, 2, 3}, 3), nullptr).right, 0);
}

TEST(Events, a_full_recording_takes_bounded_time)
{
    std::vector<float> expected;
    std::vector<float> yours;
    Random random(4);
    for (int i = 0; i < 3000; ++i) expected.insert(expected.end(), {static_cast<float>(random.below(3)), 0, 0});
    for (int i = 0; i < 5'000'000; ++i) yours.insert(yours.end(), {static_cast<float>(random.below(3)), 0, 0});
    EXPECT_LT(judged(yours, expected).right, 0.01);
    // Two long sequences without a single match: every diagonal has to be tried.
    std::vector<float> other;
    for (int i = 0; i < 30000; ++i) other.insert(other.end(), {7, 0, 0});
    EXPECT_EQ(judged(other, expected).right, 0);
}

Alignment aligned(const std::string& a, const std::string& b)
{
    return align(a.size(), b.size(), [&](std::size_t i, std::size_t j) { return a[i] == b[j]; });
}

TEST(Alignment, is_a_longest_one)
{
    Random random(11);
    for (int round = 0; round < 2000; ++round) {
        const auto word = [&] {
            std::string letters;
            for (auto size = random.below(20); size > 0; --size) letters += static_cast<char>('a' + random.below(3));
            return letters;
        };
        const std::string a = word();
        const std::string b = word();
        SCOPED_TRACE(a + " " + b);
        expect_longest(aligned(a, b), a, b);
    }
    EXPECT_EQ(aligned("abcabba", "cbabac").matches.size(), 4U) << "Myers's own example";
}

TEST(Alignment, of_long_different_sequences_is_valid_and_says_so)
{
    std::string a(20000, 'a');
    std::string b(20000, 'b');
    for (std::size_t i = 0; i < a.size(); i += 5) a[i] = b[i] = 'c';
    const Alignment found = aligned(a, b);
    EXPECT_FALSE(found.best);
    EXPECT_GT(found.matches.size(), 3000U) << "of 4000";
    for (const auto& [i, j] : found.matches) EXPECT_EQ(a[i], b[j]);
}

TEST(Events, controls_earn_what_the_most_frequent_event_does)
{
    const Check check = check_of(JudgeKind{"events"});
    const Tensor expected = floats({2, 1, 2, 1, 2, 1, 5, 0, 7, 3, 9, 4}, 2);
    const BestControl best = best_control(check, expected, nullptr, 1);
    EXPECT_EQ(best.name, "most frequent row");
    EXPECT_DOUBLE_EQ(best.right, 0.5);
    EXPECT_EQ(points_for(check, best.right, best.right), 0);
}

TEST(Events, mistakes_match_if_the_sequences_do)
{
    const Check check = check_of(JudgeKind{"events"});
    const auto same = [&](const std::vector<float>& yours, const std::vector<float>& mistake) {
        const Tensor a = floats(yours, 3);
        const Tensor b = floats(session, 3);
        return resemblance(FailingCheck{&check, &a, &b, nullptr}, floats(mistake, 3)).says == Says::for_it;
    };
    std::vector<float> fewer(session.begin(), session.end() - 3);
    std::vector<float> broken = session;
    broken[4] = nan_f;
    EXPECT_TRUE(same(fewer, fewer));
    EXPECT_TRUE(same(broken, broken));
    EXPECT_TRUE(same({}, {}));
    EXPECT_FALSE(same(fewer, broken));
    EXPECT_FALSE(same(session, fewer));
    EXPECT_FALSE(same(fewer, session));
    EXPECT_FALSE(same(fewer, {}));
}

TEST(Events, every_number_matters_and_none_is_relative_to_the_code)
{
    EXPECT_EQ(judged({2, 3, 1}, {2, 3, 0}).right, 0);
    EXPECT_EQ(judged({2, 4, 0}, {2, 3, 0}).right, 0);
    EXPECT_EQ(judged({100, 1.5F, 0}, {100, 1, 0}, relative(0.1)).right, 0);
    EXPECT_EQ(judged({100, 1.05F, 0}, {100, 1, 0}, relative(0.1)).right, 1);
}

TEST(Events, what_is_far_too_long_is_not_read_to_its_end_and_says_so)
{
    std::vector<float> yours;
    for (int i = 0; i < 2000; ++i) yours.insert(yours.end(), {9, 0, 0});
    yours.insert(yours.end(), {1, 0, 0});
    const Judgement found = judged(yours, {1, 0, 0});
    EXPECT_EQ(found.right, 0);
    EXPECT_NE(found.message.find("about 2001 that came"), std::string::npos) << found.message;
}

}
}
