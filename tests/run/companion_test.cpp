#include "run/companion.hpp"

#include <gtest/gtest.h>

#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <vector>

namespace umbral::grader {

/// Who asked what, in order.
std::vector<std::string>& asked_so_far()
{
    static std::vector<std::string> all;
    return all;
}
std::uint64_t& work_of_one_call()
{
    static std::uint64_t blocks = 0;
    return blocks;
}
int take_down(const std::string& who, int number)
{
    count_blocks(work_of_one_call());
    asked_so_far().push_back(who + std::to_string(number));
    return number;
}

namespace {

/// As often as the source "times" says.
void ask_often(Case& what, Recorder& out)
{
    const int times = std::stoi(what.source("times"));
    for (int i = 0; i < times; ++i) out.append("numbers", ask<take_down>(out, what.source("who"), i));
}

Case asking(const std::string& who, int times)
{
    return {"case", Random(1), {{"who", who}, {"times", std::to_string(times)}}};
}

/// What is asked in which order, if one case asks so often and its companion so often.
std::vector<std::string> order(int times, int beside, unsigned ahead = 0)
{
    asked_so_far().clear();
    const DriverCase one{"case", ask_often};
    std::uint32_t asked = 0;
    std::array<char, 64> function{};
    Progress progress(asked, function, {}, [] {});
    Recorder recorder(progress);
    Companion companion(one, asking("b", beside), ahead);
    progress.at_each_question([&] { companion.take_turn(); });
    Case what = asking("a", times);
    one.run(what, recorder);
    EXPECT_EQ(asked, static_cast<std::uint32_t>(times)) << "its questions are its own";
    EXPECT_EQ(recorder.tensors().at("numbers").rows, static_cast<std::uint32_t>(times));
    return asked_so_far();
}

}

TEST(Companion, asks_before_each_question)
{
    EXPECT_EQ(order(3, 3), (std::vector<std::string>{"b0", "a0", "b1", "a1", "b2", "a2"}));
}

TEST(Companion, may_have_fewer_questions)
{
    EXPECT_EQ(order(3, 1), (std::vector<std::string>{"b0", "a0", "a1", "a2"}));
    EXPECT_EQ(order(2, 0), (std::vector<std::string>{"a0", "a1"}));
}

TEST(Companion, may_be_some_questions_ahead)
{
    EXPECT_EQ(order(3, 5, 1), (std::vector<std::string>{"b0", "b1", "a0", "b2", "a1", "b3", "a2"}));
    EXPECT_EQ(order(2, 1, 3), (std::vector<std::string>{"b0", "a0", "a1"}));
}

// What is counted in a case is that case's own: a right weld lost points for its companion's work.
TEST(Companion, counts_no_work)
{
    work_of_one_call() = 100;
    const std::uint64_t before = blocks_executed();
    order(3, 5, 1);
    EXPECT_EQ(blocks_executed() - before, 300U);
    work_of_one_call() = 0;
}

TEST(Companion, is_left_where_it_is_when_the_first_has_ended)
{
    EXPECT_EQ(order(1, 1000), (std::vector<std::string>{"b0", "a0"}));
}

}
