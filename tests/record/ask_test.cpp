#include <gtest/gtest.h>

#include <stdexcept>

#include "asking.hpp"

namespace umbral {
namespace {

TEST(Ask, calls_and_takes_nothing_down_where_nobody_wants_to_know)
{
    Recorder out;
    EXPECT_EQ(ask<sum>(out, std::array{1.0F, 2.0F}, Side::back), 103.0F);
    EXPECT_TRUE(out.tensors().empty());
}

int refuse_odd(int number)
{
    if (number % 2 != 0) throw std::invalid_argument("odd");
    return number;
}

TEST(Ask, says_which_calls_end_by_an_exception)
{
    Questions questions(first_two);
    std::vector<int> begun_at_exceptions;
    int begun = 0;
    questions.at_each_question([&] { ++begun; });
    questions.at_each_exception([&] { begun_at_exceptions.push_back(begun); });
    Recorder out(questions);
    for (const int number : {2, 3, 4, 5}) {
        try {
            (void)ask<refuse_odd>(out, number);
        } catch (const std::invalid_argument&) {
        }
    }
    EXPECT_EQ(begun_at_exceptions, (std::vector{2, 4}));
}

TEST(Ask, writes_a_question_as_code_with_exact_digits)
{
    const auto tensors = asked(first_two, [](Recorder& out) {
        out.append("t", ask<meet>(out, Ray{{8, -3, 0.1F}, {-1, -0.0F, 0}}, Ball{{0, 0, 1e-30F}, 13}));
        out.append("sum", ask<sum>(out, std::array{1.5F, 3e9F}, Side::back));
    });
    EXPECT_EQ(text(tensors, "?code"),
              "0\tmeet(Ray{{8, -3, 0.1F}, {-1, -0.0F, 0}, 0, INFINITY}, Ball{{0, 0, 1e-30F}, 13})\n"
              "1\tsum(std::vector<float>{1.5F, 3e+09F}, Side::back)\n");
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?rows t"), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?rows sum"), (std::vector<std::uint32_t>{2}));
}

TEST(Ask, names_the_numbers_in_a_question)
{
    const auto tensors = asked(first_two, [](Recorder& out) {
        (void)ask<meet>(out, Ray{}, Ball{{1, 2, 3}, 4});
        (void)ask<sum>(out, std::array{5.0F, -7.0F}, Side::back);
        (void)ask<is_odd>(out, true);
    });
    EXPECT_EQ(text(tensors, "?functions"),
              "umbral::sample::meet\t0.origin.x\t0.origin.y\t0.origin.z\t0.direction.x\t0.direction.y\t0.direction.z\t"
              "0.t_min\t0.t_max\t1.centre.x\t1.centre.y\t1.centre.z\t1.radius\numbral::sample::sum\t0.size()\t"
              "the number of different elements in 0\tthe least number in 0\tthe largest number in 0\t1|front|back\n"
              "umbral::sample::is_odd\t0|false|true\n");
    EXPECT_EQ(numbers<double>(tensors, "?features 1"), (std::vector<double>{1, 2, 2, -7, 5, 1}));
}

TEST(Ask, passes_on_what_is_written_to)
{
    std::vector<float> list = {9};
    const auto tensors = asked(first_two, [&](Recorder& out) { ask<append_twice>(out, 4, list); });
    EXPECT_EQ(list, (std::vector<float>{9, 4, 4}));
    EXPECT_EQ(text(tensors, "?code"), "0\tauto filled = std::vector<float>{9};|append_twice(4, filled);|filled\n");
}

TEST(Ask, tells_how_long_the_lists_in_answers_are)
{
    std::vector<float> list;
    const auto tensors = asked(first_two, [&](Recorder& out) {
        ask<append_twice>(out, 4, list);
        (void)ask<sum>(out, std::array{1.0F}, Side::back);
        EXPECT_EQ(ask<shape_of>(out, 3).corners.size(), 3U);
        EXPECT_EQ(ask<shape_of>(out, 0).name, "0");
        ask<append_twice>(out, 5, list);
    });
    EXPECT_EQ(text(tensors, "?sized"), "umbral::sample::append_twice\t1\numbral::sample::shape_of\tcorners\tname\n");
    const std::vector<double> appended = numbers<double>(tensors, "?sizes 0");
    ASSERT_EQ(appended.size(), 4U);
    EXPECT_EQ(appended[1], 2);
    EXPECT_TRUE(std::isnan(appended[3])) << "there was something in it before";
    EXPECT_EQ(numbers<double>(tensors, "?sizes 1"), (std::vector<double>{2, 3, 1, 3, 0, 1}));
}

TEST(Ask, of_an_object_tells_all_that_was_done_to_it)
{
    const auto tensors = asked({.questions = true, .wanted = {3, 4}}, [](Recorder& out) {
        const auto counter = ask_new<make_counter>(out, "counter", 5);
        ask<&Counter::add>(out, *counter, 2);
        ask<&Counter::add>(out, *counter, -1);
        out.append("total", ask<&Counter::total>(out, *counter));
        out.append("total", ask<&Counter::total>(out, *counter));
    });
    EXPECT_EQ(text(tensors, "?code"),
              "3\tconst auto counter = make_counter(5);|counter->add(2);|counter->add(-1);|counter->total()\n"
              "4\tconst auto counter = make_counter(5);|counter->add(2);|counter->add(-1);|counter->total()\n");
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?rows total"), (std::vector<std::uint32_t>{4, 5}));
}

TEST(Ask, makes_an_object_of_arguments_that_are_gone_then)
{
    const auto number = std::make_shared<int>(5);
    Recorder out;
    const auto keeper = ask_new<make_keeper>(out, "keeper", number);
    EXPECT_NE(*keeper, &number);
    EXPECT_EQ(number.use_count(), 1);
}

TEST(Ask, of_what_objects_are_handed_to_tells_how_they_stand)
{
    const auto tensors = asked({.wanted = {1}}, [](Recorder& out) {
        const auto counter = ask_new<make_counter>(out, "counter", 5);
        const Step step = [](Counter& to) { to.add(1); };
        if (Questions* const questions = out.questions()) questions->set_object(&step, "step", "const Step step = …;");
        ask<take_steps>(out, *counter, step, 3);
        EXPECT_EQ(counter->total(), 8);
    });
    EXPECT_EQ(text(tensors, "?code"),
              "1\tconst auto counter = make_counter(5);|const Step step = …;|take_steps(counter, step, 3)\n");
}

TEST(Ask, of_one_of_two_objects_tells_what_was_done_to_both)
{
    const auto tensors = asked({.wanted = {3}}, [](Recorder& out) {
        const auto one = ask_new<make_counter>(out, "one", 5);
        const auto other = ask_new<make_counter>(out, "other", 6);
        ask<&Counter::add>(out, *other, 2);
        (void)ask<&Counter::total>(out, *one);
    });
    EXPECT_EQ(text(tensors, "?code"),
              "3\tconst auto one = make_counter(5);|const auto other = make_counter(6);"
              "|other->add(2);|one->total()\n");
}

TEST(Ask, leaves_out_the_middle_of_long_stories_and_lists_unless_in_full)
{
    const auto run = [](Recorder& out) {
        const auto counter = ask_new<make_counter>(out, "counter", 5);
        for (int i = 0; i < 16; ++i) ask<&Counter::add>(out, *counter, i);
        (void)ask<&Counter::total>(out, *counter);
        (void)ask<sum>(out, std::vector<float>(20, 1.0F), Side::front);
    };
    EXPECT_EQ(
        text(asked({.wanted = {17, 18}}, run), "?code"),
        "17\tconst auto counter = make_counter(5);|// … 5 calls left out|counter->add(5);|counter->add(6);"
        "|counter->add(7);|counter->add(8);|counter->add(9);|counter->add(10);|counter->add(11);|counter->add(12);"
        "|counter->add(13);|counter->add(14);|counter->add(15);|counter->total()\n"
        "18\tsum(std::vector<float>{1, 1, 1, … 17 more}, Side::front)\n");
    const std::string full = text(asked({.wanted = {17, 18}, .in_full = true}, run), "?code");
    EXPECT_NE(full.find("counter->add(0);|counter->add(1)"), std::string::npos);
    EXPECT_EQ(full.find("…"), std::string::npos);
}

TEST(Ask, links_a_picture_to_the_questions_since_the_last_one)
{
    const auto tensors = asked(first_two, [](Recorder& out) {
        Grid<float> cells(2, 1);
        for (float& cell : cells.cells) cell = ask<meet>(out, Ray{}, Ball{}).value();
        out.buffer("cells", cells);
        for (float& cell : cells.cells) cell = ask<meet>(out, Ray{}, Ball{}).value();
        out.buffer("more", cells);
        out.buffer("the same once more", cells);
    });
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?whole cells"), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?whole more"), (std::vector<std::uint32_t>{2, 2}));
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?whole the same once more"), (std::vector<std::uint32_t>{2, 2}));
}

TEST(Ask, links_a_tile_of_a_picture_to_the_last_questions)
{
    const auto tensors = asked(first_two, [](Recorder& out) {
        for (int i = 0; i < 3; ++i) (void)ask<meet>(out, Ray{}, Ball{});
        out.tile("cells", 0, 2, 4, 1, 2);
        out.tile("never recorded", 0, 0, 4, 4);
        out.buffer("cells", Grid<float>(4, 3));
    });
    EXPECT_EQ(numbers<std::uint32_t>(tensors, "?tiles cells"), (std::vector<std::uint32_t>{1, 2, 0, 2, 4, 1, 4}));
    EXPECT_FALSE(tensors.contains("?tiles never recorded"));
}

TEST(Recorder, takes_the_names_of_a_tables_numbers_once)
{
    Recorder out;
    for (int i = 0; i < 2; ++i) out.columns("state", i == 0 ? "colour/4, width" : "others");
    EXPECT_EQ(text(out.tensors(), "state.names"), "colour/4, width");
}

TEST(Recorder, tells_which_rows_are_refusals)
{
    Recorder out;
    out.append("t", 1.0F);
    out.refused("t", "expected a number,\ngot a comma");
    out.append("t", 0.0F);
    for (int i = 0; i < 1000; ++i) out.refused("u", std::string(1000, 'x'));
    out.finish();
    EXPECT_EQ(text(out.tensors(), "t.refusals"), "1\texpected a number, got a comma\n");
    EXPECT_LE(text(out.tensors(), "u.refusals").size(), refusals::most_bytes);
}

}
}
