#include <gtest/gtest.h>

#include <limits>

#include "report/curve_places.hpp"
#include "report/curve_plot.hpp"
#include "report/curve_words.hpp"
#include "report/layout.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

/// Errors and times as of raytracing/sphere; the student's own given.
UnitCurve curve_with(double error, double seconds)
{
    return {"ray-sphere",
            "far away/t",
            "picture",
            "ulp",
            {"", error, seconds},
            {{"school formula", 4000, 0.007},
             {"reference", 6, 0.010},
             {"double precision", 0.5, 0.014},
             {"oracle", 0, 0.13}}};
}

TEST(Curve, one_sentence_says_where_a_choice_lies)
{
    EXPECT_EQ(curve_sentence(curve_with(0.6, 0.0075)),
              "As accurate as “double precision”, in the time of “school formula”.");
    EXPECT_EQ(curve_sentence(curve_with(5, 0.011)), "As accurate as the reference, in the same time.");
    EXPECT_EQ(curve_sentence(curve_with(0.5, 0.05)), "As accurate as “double precision”, in 3.6 times its time.");
    EXPECT_EQ(curve_sentence(curve_with(400, 0.0071)), "In the time of “school formula”, with 0.1 times its error.");
    EXPECT_EQ(curve_sentence(curve_with(60, 0.04)),
              "Beside the reference: in 4 times its time, with 10 times its error.");
    EXPECT_EQ(curve_sentence(curve_with(0, 0.13)), "As accurate as the oracle, in the same time.");
    EXPECT_EQ(curve_sentence(curve_with(1e-3, 0.13)), "In the time of the oracle, with an error where it has none.");
}

TEST(Curve, places_are_logarithms_and_no_error_lies_below_a_gap)
{
    const std::vector<CurvePlace> places = curve_places(curve_with(6, 0.010));
    ASSERT_EQ(places.size(), 5U);
    EXPECT_DOUBLE_EQ(places[0].x, 0);
    EXPECT_DOUBLE_EQ(places[0].y, 1);
    EXPECT_DOUBLE_EQ(places[3].x, 1);
    EXPECT_DOUBLE_EQ(places[3].y, 0);
    EXPECT_GT(places[2].y, 0.19);
    EXPECT_DOUBLE_EQ(places[4].x, places[1].x);
    EXPECT_DOUBLE_EQ(places[4].y, places[1].y);
    EXPECT_EQ(curve_front(curve_with(6, 0.010)), (std::vector<std::size_t>{0, 1, 2, 3}));
    UnitCurve beaten = curve_with(6, 0.010);
    beaten.others[2].error = 7;
    EXPECT_EQ(curve_front(beaten), (std::vector<std::size_t>{0, 1, 3}));
}

TEST(Curve, any_values_lie_within_the_plot)
{
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const double error : {0.0, least, 1.0, largest})
        for (const double seconds : {least, 1.0, largest})
            for (const double other : {0.0, least, largest}) {
                const UnitCurve curve{"k", "c", "t", "", {"", error, seconds}, {{"reference", other, 1}}};
                for (const CurvePlace& place : curve_places(curve)) {
                    EXPECT_TRUE(place.x >= 0 && place.x <= 1) << error << ' ' << seconds << ' ' << other;
                    EXPECT_TRUE(place.y >= 0 && place.y <= 1) << error << ' ' << seconds << ' ' << other;
                }
                EXPECT_FALSE(curve_sentence(curve).empty());
            }
}

TEST(Curve, a_terminal_draws_it_for_one_unit_and_says_a_sentence_for_each_of_several)
{
    UnitResult unit = unit_result("raytracing/sphere", Verdict::ok, {check_result("far away/t", 1, 1)});
    unit.curve = curve_with(0.6, 0.0075);
    const auto report = [](const std::vector<UnitResult>& units, const TerminalStyle& style) {
        return terminal_report(submission_result("ana", units), style);
    };
    const std::string one = report({unit}, {});
    EXPECT_NE(one.find("◆ yours"), std::string::npos) << one;
    EXPECT_NE(one.find("a school formula"), std::string::npos) << one;
    EXPECT_NE(one.find("umbral bench accuracy ray-sphere"), std::string::npos) << one;
    const std::string several = report({unit, unit}, {});
    EXPECT_NE(several.find("raytracing/sphere: As accurate as “double precision”"), std::string::npos) << several;
    EXPECT_EQ(several.find("◆"), std::string::npos) << several;
    for (const int width : {60, 100}) {
        const std::string ascii = report({unit}, {.unicode = false, .width = width});
        for (const char c : ascii) EXPECT_LT(static_cast<unsigned char>(c), 0x80U) << ascii;
        for (const std::string_view line : lines_of(ascii)) EXPECT_LE(display_width(line), width) << line;
    }
}

TEST(Curve, points_in_one_place_are_all_seen)
{
    UnitCurve curve = curve_with(1, 0.01);
    for (CurvePoint& one : curve.others) one.error = 1, one.seconds = 0.01;
    std::string text;
    for (const std::string& line : curve_plot(curve, 80, Paint({}))) text += line.substr(0, line.find("yours")) + "\n";
    for (const char* mark : {"a", "b", "c", "d", "◆"})
        EXPECT_NE(text.find(mark), std::string::npos) << mark << '\n' << text;
}

}
}
