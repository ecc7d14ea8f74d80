#include <gtest/gtest.h>

#include "asking.hpp"

// Other questions than the driver's.
namespace umbral {
namespace {

TEST(Ask, can_ask_another_question_in_place_of_the_drivers)
{
    const auto answer = [](const OtherQuestion& other) {
        const auto run = [](Recorder& out) {
            out.append("t", ask<meet>(out, Ray{}, Ball{{1, 2, 3}, 4}));
            out.append("sum", ask<sum>(out, std::array{5.0F, -7.0F}, Side::back));
        };
        const auto tensors = asked({}, run, other);
        return std::pair(tensors.find("t")->second.present[0] == 1 ? numbers<float>(tensors, "t")[0] : -1,
                         numbers<float>(tensors, "sum")[0]);
    };
    const std::string meet = "umbral::sample::meet";
    EXPECT_EQ(answer({meet, "1.radius", "doubled", ""}), std::pair(8.0F, 98.0F));
    EXPECT_EQ(answer({meet, "0.direction", "negated", ""}), std::pair(-1.0F, 98.0F));
    EXPECT_EQ(answer({meet, "0.direction", "", "1.centre"}), std::pair(-1.0F, 98.0F));
    EXPECT_EQ(answer({"umbral::sample::sum", "0", "without its last element", ""}), std::pair(4.0F, 105.0F));
    EXPECT_EQ(answer({"umbral::sample::sum", "1", "taken as front", ""}), std::pair(4.0F, -2.0F));
    EXPECT_EQ(answer({meet, "1.radius", "taken as", "0.t_min"}), std::pair(0.0F, 98.0F));
    EXPECT_EQ(answer({meet, "no such place", "negated", ""}), std::pair(4.0F, 98.0F));
    EXPECT_EQ(answer({"", "umbral::sample::Ball.radius", "doubled", ""}), std::pair(8.0F, 98.0F));
    EXPECT_EQ(answer({"", "umbral::Ray.direction", "negated", ""}), std::pair(-1.0F, 98.0F));
}

TEST(Ask, lists_what_could_be_asked_instead)
{
    const auto tensors = asked(first_two, [](Recorder& out) {
        (void)ask<meet>(out, Ray{}, Ball{{1, 2, 3}, 4});
        (void)ask<sum>(out, std::array{5.0F}, Side::back);
        (void)ask<is_odd>(out, true);
    });
    const std::string others = text(tensors, "?others");
    for (const char* const line :
         {"umbral::sample::meet\t0.direction\tnegated\t\n", "umbral::sample::meet\t0.origin\t\t0.direction\n",
          "umbral::sample::meet\t0.t_min\t\t1.radius\n", "\t1.radius\tsquared\t\n", "\tumbral::Ray.t_min\tnegated\t\n",
          "umbral::sample::meet\t0.direction\ttaken as\t0.origin\n",
          "\tumbral::Ray.t_max\ttaken as\tumbral::Ray.t_min\n", "umbral::sample::sum\t1\ttaken as front\t\n",
          "umbral::sample::sum\t1\ttaken as back\t\n", "umbral::sample::is_odd\t0\ttaken as true\t\n",
          "umbral::sample::is_odd\t0\ttaken as false\t\n"})
        EXPECT_NE(others.find(line), std::string::npos) << line << "in\n" << others;
}

TEST(Ask, tells_what_the_answers_of_an_object_may_come_of)
{
    const auto tensors = asked({.questions = true}, [](Recorder& out) {
        (void)ask<is_odd>(out, true);
        const auto counter = ask_new<make_counter>(out, "counter", 5);
        ask<&Counter::add>(out, *counter, 2);
        (void)ask<&Counter::total>(out, *counter);
    });
    EXPECT_EQ(text(tensors, "?histories"),
              "umbral::sample::Counter::add\tumbral::sample::make_counter\n"
              "umbral::sample::Counter::total\tumbral::sample::Counter::add\tumbral::sample::make_counter\n");
}

TEST(Ask, can_ask_another_question_in_all_that_was_done_to_an_object)
{
    const auto run = [](Recorder& out) {
        const auto counter = ask_new<make_counter>(out, "counter", 5);
        ask<&Counter::add>(out, *counter, 2);
        out.append("total", ask<&Counter::total>(out, *counter));
    };
    const OtherQuestion other{
        "umbral::sample::make_counter", "0", "doubled", "", {{"umbral::sample::Counter::add", "0"}}};
    EXPECT_EQ(numbers<std::int32_t>(asked({}, run, other), "total"), (std::vector<std::int32_t>{14}));
}

}
}
