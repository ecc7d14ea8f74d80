#include <gtest/gtest.h>

#include <bench/accuracy/axis.hpp>
#include <bench/accuracy/labels.hpp>
#include <bench/accuracy/page.hpp>
#include <bench/accuracy/plot.hpp>
#include <bench/accuracy/text.hpp>
#include <cmath>
#include <limits>
#include <regex>

#include "synthetic.hpp"

namespace umbral::bench {
namespace {

int count_of(const std::string& text, const std::string& part)
{
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

/// Every element that is opened is closed, in the right order. Enough for what is written here.
void expect_well_formed(const std::string& text)
{
    std::vector<std::string> open;
    static const std::regex tag("<(/?)([a-zA-Z0-9]+)([^<>]*)>");
    for (auto found = std::sregex_iterator(text.begin(), text.end(), tag); found != std::sregex_iterator(); ++found) {
        const std::string name = (*found)[2];
        const std::string rest = (*found)[3];
        if ((*found)[1].length() > 0) {
            ASSERT_FALSE(open.empty()) << name;
            ASSERT_EQ(open.back(), name);
            open.pop_back();
        } else if (!rest.ends_with('/') && name != "meta" && name != "br") {
            open.push_back(name);
        }
    }
    EXPECT_TRUE(open.empty()) << open.back();
}

TEST(LogAxis, puts_decades_at_equal_distances)
{
    const LogAxis axis({1, 100, 10, 0, -4, NAN, INFINITY}, 100, 300, 0, 0);
    EXPECT_NEAR(axis.at(1), 100, 1e-9);
    EXPECT_NEAR(axis.at(10), 200, 1e-9);
    EXPECT_NEAR(axis.at(100), 300, 1e-9);
    const LogAxis upwards({1, 100}, 300, 100, 50, 0);
    EXPECT_NEAR(upwards.at(1), 250, 1e-9);
    EXPECT_NEAR(upwards.at(100), 100, 1e-9);
}

TEST(LogAxis, stands_one_value_or_none)
{
    for (const std::vector<double>& values : {std::vector<double>{7}, {}, {0, -1}}) {
        const LogAxis axis(values, 0, 100, 10, 10);
        const double middle = axis.at(values.size() == 1 ? 7 : 1);
        EXPECT_NEAR(middle, 50, 1e-9);
        EXPECT_FALSE(axis.ticks().empty());
    }
}

TEST(LogAxis, labels_fewer_ticks_where_there_are_many_decades)
{
    for (const LogAxis::Tick& tick : LogAxis({1e-3, 1e6}, 0, 500, 0, 0).ticks())
        EXPECT_EQ(tick.labelled, std::abs(std::log10(tick.value) - std::round(std::log10(tick.value))) < 1e-9);
    for (const LogAxis::Tick& tick : LogAxis({1, 40}, 0, 500, 0, 0).ticks()) EXPECT_TRUE(tick.labelled) << tick.value;
}

TEST(Labels, keep_clear_of_each_other_and_of_the_border)
{
    Labels labels({0, 0, 100, 60});
    const std::optional<Place> first = labels.beside(50, 30, "abc", false);
    ASSERT_TRUE(first);
    const std::optional<Place> second = labels.beside(50, 30, "abc", false);
    ASSERT_TRUE(second);
    EXPECT_TRUE(std::abs(first->x - second->x) > 3 * 6 || std::abs(first->y - second->y) > 12);
    EXPECT_EQ(labels.beside(98, 30, "a label far too long for what is left", false), std::nullopt);
    EXPECT_TRUE(labels.beside(98, 30, "a label far too long for what is left", true));
    EXPECT_EQ(text_width("10⁶"), text_width("100"));
}

TEST(Labels, push_the_names_of_lines_apart)
{
    Labels labels({0, 0, 300, 200});
    const std::vector<Place> places =
        labels.name_ends({{"low", 100, 190}, {"same", 100, 190}, {"again", 100, 190}, {"top", 100, 3}}, false);
    std::vector<double> heights;
    for (const Place& place : places) heights.push_back(place.y);
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GE(heights[i] - heights[i - 1], 14.9);
    EXPECT_GE(heights.front(), 10);
    EXPECT_LE(heights.back(), 200);
}

TEST(Svg, draws_every_mark_and_rings_the_knee)
{
    const Plot plot{"p",
                    "A plot",
                    "time",
                    "error",
                    {{"one",
                      {{1, 100, "a", "tip a", false, false},
                       {2, 1, "b", "tip b\nmore", true, false},
                       {4, 50, "", "c", false, true}},
                      true}}};
    const std::string svg = svg_of(plot);
    expect_well_formed(svg);
    EXPECT_EQ(count_of(svg, "class=\"mark"), 3);
    EXPECT_EQ(count_of(svg, "class=\"mark quiet\""), 1);
    EXPECT_EQ(count_of(svg, "class=\"ring\""), 1);
    EXPECT_EQ(count_of(svg, "tabindex=\"0\""), 3);
    EXPECT_NE(svg.find("label knee"), std::string::npos);
    EXPECT_NE(svg.find(">more</text>"), std::string::npos);
    // The line joins the two that are not quiet.
    EXPECT_TRUE(std::regex_search(svg, std::regex("class=\"line\" d=\"M[0-9. ]+L[0-9. ]+\"")));
}

TEST(Svg, leaves_out_what_cannot_be_drawn)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = svg_of({"p",
                                    "t",
                                    "x",
                                    "y",
                                    {{"",
                                      {{0, 1, "", "", false, false},
                                       {1, nan, "", "", false, false},
                                       {1, -1, "", "", false, false},
                                       {INFINITY, 1, "", "", false, false},
                                       {3, 0, "", "", false, false}},
                                      true}}});
    EXPECT_EQ(count_of(svg, "class=\"mark"), 1);
    EXPECT_EQ(count_of(svg, "class=\"zero\""), 1);  // the line of zeros
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    expect_well_formed(svg_of({"p", "t", "x", "y", {}}));
}

TEST(Svg, escapes_every_text)
{
    const std::string bad = "<script>\"&'";
    const std::string svg =
        svg_of({"p", bad, bad, bad, {{bad, {{1, 1, bad, bad, true, false}, {2, 2, bad, bad, false, false}}, true}}});
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(count_of(svg, "&lt;script&gt;&quot;&amp;&#39;"), 3 + 1 + 2 + 4);
    expect_well_formed(svg);
}

TEST(Page, is_complete_in_itself)
{
    const std::string page = page_of(test::synthetic());
    expect_well_formed(page.substr(page.find("<html")));
    for (const char* foreign : {"http://", "https://", "src=", "<script", "<link", "@import", "url("})
        EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
    EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
    EXPECT_NE(page.find("A &lt;bend&gt; &amp; more"), std::string::npos);
    EXPECT_NE(page.find("Some &lt;CPU&gt;"), std::string::npos);
    // Two curves of the first knob; of the second, with one measure, the situations together.
    EXPECT_EQ(count_of(page, "<svg class=\"plot\""), 3);
    EXPECT_EQ(count_of(page, "<table>"), 2);
    EXPECT_EQ(count_of(page, "<tr class=\"knee\">"), 1);
    EXPECT_NE(page.find("s1: 1 px at 2 ms"), std::string::npos);
}

TEST(Text, shows_front_and_knee)
{
    const std::string text = text_of(test::synthetic());
    EXPECT_NE(text.find("  > s1 "), std::string::npos) << text;
    EXPECT_EQ(count_of(text, "s4"), 0);  // beaten
    EXPECT_NE(text.find("far away"), std::string::npos);
}

}
}
