#include "question/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <umbral/record/ask.hpp>

namespace umbral::sample {

/// Adds what it is told, and is asked for the sum.
class Sum {
public:
    void add(float more) { sum_ += more; }
    void scale(float times, bool twice) { sum_ *= twice ? 2 * times : times; }
    [[nodiscard]] float value(float factor) const { return factor * sum_; }

private:
    float sum_ = 0;
};
std::unique_ptr<Sum> make_sum(float first)
{
    auto made = std::make_unique<Sum>();
    made->add(first);
    return made;
}

}

namespace umbral::grader {
namespace {

using sample::Sum;

constexpr const char* headers =
    "class Sum { void add(float more); void scale(float times, bool twice); float value(float factor) const; };"
    "std::unique_ptr<Sum> make_sum(float first);";
constexpr const char* value = "umbral::sample::Sum::value";

void ask_value(Recorder& out, const Sum& sum) { out.append("value", ask<&Sum::value>(out, sum, 1)); }

TEST(History, tells_the_last_calls_before_each_question)
{
    Questions questions({.questions = true});
    Recorder out(questions);
    const auto first = ask_new<sample::make_sum>(out, "sum", 5.0F);
    ask_value(out, *first);
    ask<&Sum::add>(out, *first, 7);
    ask<&Sum::scale>(out, *first, 2, true);
    ask_value(out, *first);
    ask<&Sum::add>(out, *first, 8);
    ask_value(out, *first);
    const auto second = ask_new<sample::make_sum>(out, "sum", 6.0F);
    ask_value(out, *second);
    // One whose answer is looked at made nothing that is asked afterwards.
    out.append("made", ask<sample::make_sum>(out, 9)->value(1));
    ask<&Sum::add>(out, *second, 3);
    ask_value(out, *second);
    out.finish();
    const QuestionLog log = read_questions(out.tensors());

    const History history(log, value);
    const std::vector<std::string> names = history.names(headers);
    const auto column = [&](const std::string& name) {
        const auto place = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        std::vector<double> numbers;
        for (const std::uint32_t question : log.rows.at("value"))
            numbers.push_back(place < names.size() ? history.numbers(question - 1).at(place) : -1);
        for (double& number : numbers)
            if (std::isnan(number)) number = 0;
        return numbers;
    };
    using Numbers = std::vector<double>;
    EXPECT_EQ(column("more of add"), (Numbers{0, 7, 8, 0, 3}));
    EXPECT_EQ(column("times of scale"), (Numbers{0, 2, 2, 0, 0}));
    EXPECT_EQ(column("twice of scale"), (Numbers{0, 1, 1, 0, 0}));
    EXPECT_EQ(column("first of make_sum"), (Numbers{5, 5, 5, 6, 9}));
    const Numbers last = column("the last change before it");
    const std::vector<std::string> functions = history.words().back();
    std::vector<std::string> called;
    for (const double which : last) called.push_back(functions.at(static_cast<std::size_t>(which)));
    EXPECT_EQ(called, (std::vector<std::string>{"make_sum", "scale", "add", "make_sum", "add"}));
    EXPECT_EQ(history.words().size(), names.size());
}

TEST(History, has_nothing_to_tell_of_plain_functions)
{
    Questions questions({.questions = true});
    Recorder out(questions);
    out.append("made", ask<sample::make_sum>(out, 9)->value(1));
    out.finish();
    const QuestionLog log = read_questions(out.tensors());
    const History history(log, "umbral::sample::make_sum");
    EXPECT_TRUE(history.names(headers).empty());
    EXPECT_TRUE(history.words().empty());
    EXPECT_TRUE(history.numbers(0).empty());
}

}
}
