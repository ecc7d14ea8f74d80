#include <gtest/gtest.h>

#include <bench/accuracy/knee.hpp>
#include <cmath>
#include <limits>

namespace umbral::bench {
namespace {

using Indices = std::vector<std::size_t>;

TEST(ParetoFront, leaves_out_what_is_beaten)
{
    //                                 0       1       2       3 beaten by 1   4       5 dearer, no better
    const std::vector<Offer> offers = {{1, 9}, {2, 5}, {8, 1}, {3, 6}, {4, 3}, {9, 1}};
    EXPECT_EQ(pareto_front(offers), (Indices{0, 1, 4, 2}));
}

TEST(ParetoFront, keeps_the_first_of_equals_and_the_better_of_equal_times)
{
    EXPECT_EQ(pareto_front(std::vector<Offer>{{1, 5}, {1, 5}, {1, 4}, {1, 4}}), (Indices{2}));
    EXPECT_EQ(pareto_front({}), Indices{});
}

TEST(ParetoFront, takes_no_noise_for_a_gain)
{
    EXPECT_EQ(pareto_front(std::vector<Offer>{{1, 5}, {2, 4.96}, {3, 4.94}}), (Indices{0, 2}));
}

TEST(ParetoFront, ignores_what_is_no_measurement)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(
        pareto_front(std::vector<Offer>{{nan, 1}, {1, nan}, {0, 0}, {-1, 0}, {INFINITY, 0}, {2, INFINITY}, {5, 7}}),
        (Indices{6}));
}

/// Error falls as time^-2 up to time 16, and as time^-0.25 beyond: the bend is there by construction.
std::vector<Offer> bent()
{
    std::vector<Offer> offers;
    for (int i = 0; i <= 10; ++i) {
        const double time = std::exp2(i);
        offers.push_back(
            {time, i <= 4 ? 1000 * std::pow(time, -2) : 1000 * std::pow(16, -2) * std::pow(time / 16, -0.25)});
    }
    return offers;
}

TEST(Knee, is_where_the_curve_bends)
{
    const std::vector<Offer> offers = bent();
    const Indices front = pareto_front(offers);
    ASSERT_EQ(front.size(), offers.size());
    EXPECT_EQ(knee_of(offers, front), 4U);
    EXPECT_NEAR(gain_of_doubling(offers[0], offers[4]), 4, 1e-12);
    EXPECT_NEAR(gain_of_doubling(offers[4], offers[10]), std::exp2(0.25), 1e-12);
}

TEST(Knee, does_not_move_with_the_units)
{
    for (const double scale : {1e-9, 1e6}) {
        std::vector<Offer> offers = bent();
        for (Offer& offer : offers) offer = {offer.time * scale, offer.error * scale * scale};
        EXPECT_EQ(knee_of(offers, pareto_front(offers)), 4U) << scale;
        for (Offer& offer : offers) offer.time = std::pow(offer.time, 3);  // an axis stretched
        EXPECT_EQ(knee_of(offers, pareto_front(offers)), 4U) << scale;
    }
}

TEST(Knee, is_none_without_a_bend)
{
    std::vector<Offer> straight;
    std::vector<Offer> bulging;
    for (int i = 0; i < 6; ++i) {
        straight.push_back({std::exp2(i), std::exp2(-i)});
        bulging.push_back({std::exp2(i), std::exp2(-0.2 * i * i)});
    }
    EXPECT_EQ(knee_of(straight, pareto_front(straight)), std::nullopt);
    EXPECT_EQ(knee_of(bulging, pareto_front(bulging)), std::nullopt);
    EXPECT_EQ(knee_of(std::vector<Offer>{{1, 5}, {2, 1}}, Indices{0, 1}), std::nullopt);
    EXPECT_EQ(knee_of({}, {}), std::nullopt);
}

// What is dearer and no better prolongs the curve: the last setting that buys something is the knee.
TEST(Knee, may_be_the_last_of_the_front)
{
    const std::vector<Offer> offers = {{10, 5000}, {11, 0.5}, {12, 3}, {700, 0.5}};
    EXPECT_EQ(pareto_front(offers), (Indices{0, 1}));
    EXPECT_EQ(knee_of(offers, pareto_front(offers)), 1U);
    EXPECT_EQ(knee_of(std::vector<Offer>{{1, 5}, {2, 6}, {9, 7}}, Indices{0}), std::nullopt);
}

// (1, 8) (2, 1) (16, 0): the zero stands for 0.5, half of the least. Chord from 3 to -1 over 4 doublings; the middle
// lies 2 below it.
TEST(Knee, takes_an_error_of_nothing)
{
    const std::vector<Offer> offers = {{1, 8}, {2, 1}, {16, 0}};
    EXPECT_EQ(knee_of(offers, pareto_front(offers)), 1U);
}

Knob knob_with(const std::vector<Offer>& offers)
{
    Knob knob{"k", "Title", "", "ms", "", {{"e", "error", "px"}}, {{"s", "here", 1}}, {}, {}, {}};
    for (std::size_t i = 0; i < offers.size(); ++i) {
        knob.settings.emplace_back("setting " + std::to_string(i), "");
        knob.results.push_back({"setting " + std::to_string(i), "s", offers[i].time, {{"e", offers[i].error}}});
    }
    return knob;
}

TEST(Curve, says_it_in_plain_words)
{
    // Error falls as 1/time beyond the knee at (2, 1): halving it costs twice the time.
    const Curve bend = curve_of(knob_with({{1, 100}, {2, 1}, {4, 0.5}, {8, 0.25}, {9, 0.5}}), "s", "e");
    EXPECT_EQ(bend.front, (std::vector<std::string>{"setting 0", "setting 1", "setting 2", "setting 3"}));
    EXPECT_EQ(bend.knee, "setting 1");
    EXPECT_EQ(bend.sentence, "setting 1: 1 px at 2 ms; beyond it, halving the error costs 2 times the time.");

    const Curve flat = curve_of(knob_with({{1, 100}, {2, 1}, {400, 0.98}}), "s", "e");
    EXPECT_EQ(flat.sentence, "setting 1: 1 px at 2 ms; beyond it, 200 times the time leaves 0.98 px.");
    const Curve last = curve_of(knob_with({{1, 100}, {2, 1}, {400, 1}}), "s", "e");
    EXPECT_EQ(last.sentence, "setting 1: 1 px at 2 ms; up to 200 times the time buys nothing more.");
    const Curve straight = curve_of(knob_with({{1, 4}, {2, 2}, {4, 1}}), "s", "e");
    EXPECT_EQ(straight.knee, std::nullopt);
    EXPECT_EQ(straight.sentence, "setting 0: 4 px at 1 ms; setting 2: 1/4 of that error for 4 times the time.");
    EXPECT_EQ(curve_of(knob_with({{1, 4}, {2, 5}}), "s", "e").sentence,
              "setting 0: 4 px at 1 ms, and nothing else is better in anything.");
}

TEST(NumberText, is_short)
{
    for (const auto& [value, text] : std::vector<std::pair<double, std::string>>{{0, "0"},
                                                                                 {1, "1"},
                                                                                 {0.5, "0.5"},
                                                                                 {0.31249, "0.312"},
                                                                                 {0.00123, "0.00123"},
                                                                                 {12.34, "12.3"},
                                                                                 {999.4, "999"},
                                                                                 {1000, "1 000"},
                                                                                 {8174, "8 170"},
                                                                                 {123456, "123 000"},
                                                                                 {1e6, "1.00e+06"},
                                                                                 {9.44e-4, "0.000944"},
                                                                                 {1e-6, "1.00e-06"},
                                                                                 {-2.5, "-2.5"},
                                                                                 {INFINITY, "infinite"}})
        EXPECT_EQ(number_text(value), text);
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "not a number");
}

}
}
