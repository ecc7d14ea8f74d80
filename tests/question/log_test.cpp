#include "question/log.hpp"

#include <gtest/gtest.h>

#include <umbral/record/ask.hpp>

namespace umbral::sample {

struct Disc {
    glm::vec2 centre;
    float radius;
};
float area(const Disc& disc) { return disc.radius; }
float twice(float x) { return 2 * x; }
enum class Rule { even_odd, nonzero };
float choose(bool closed, Rule rule, int n) { return closed && rule == Rule::even_odd ? 0 : static_cast<float>(n); }

}

namespace umbral::grader {
namespace {

QuestionLog log_of(const Inquiry& inquiry)
{
    Questions questions(inquiry);
    Recorder out(questions);
    out.append("before", 1.0F);
    out.append("area", ask<sample::area>(out, sample::Disc{{1, 2}, 3}));
    out.append("area", ask<sample::area>(out, sample::Disc{{4, 5}, 6}));
    out.append("twice", ask<sample::twice>(out, 7));
    ask_in_words(out, [] { return "two\nlines"; });
    out.buffer("whole", Grid<float>(2, 2));
    out.tile("tiles", 2, 0, 2, 3);
    out.tile("tiles", 2, 3, 2, 1, 3);
    out.buffer("tiles", Grid<float>(5, 4));
    out.finish();
    return read_questions(out.tensors());
}

TEST(QuestionLog, tells_the_question_behind_each_row)
{
    const QuestionLog log = log_of({.questions = true, .wanted = {0, 2, 3}});
    EXPECT_EQ(log.question_of("before", 0, 1), std::nullopt);
    EXPECT_EQ(log.question_of("area", 1, 2), 1U);
    EXPECT_EQ(log.question_of("area", 2, 2), std::nullopt);
    EXPECT_EQ(log.question_of("twice", 0, 1), 2U);
    EXPECT_EQ(log.question_of("no such value", 0, 1), std::nullopt);
    EXPECT_EQ(log.code.at(0), "area(Disc{{1, 2}, 3})");
    EXPECT_EQ(log.code.at(2), "twice(7)");
    EXPECT_EQ(log.code.at(3), "two\nlines");
    EXPECT_FALSE(log.code.contains(1));
}

TEST(QuestionLog, of_a_picture_knows_the_question_only_if_each_cell_has_one)
{
    const QuestionLog log = log_of({.questions = true});
    EXPECT_EQ(log.question_of("whole", 3, 4), 3U) << "four questions, four cells";
    EXPECT_EQ(log.question_of("whole", 1, 3), std::nullopt);
    EXPECT_EQ(log.question_of("whole", 0, 0), std::nullopt);
}

TEST(QuestionLog, of_a_picture_knows_all_that_led_to_it_and_of_a_tile_its_own)
{
    const QuestionLog log = log_of({.questions = true});
    EXPECT_EQ(log.questions_of("whole", 1, 3), (QuestionSpan{0, 4}));
    EXPECT_EQ(log.questions_of("whole", 3, 4), (QuestionSpan{3, 1}));
    EXPECT_EQ(log.questions_of("tiles", 5 * 2 + 3, 20), (QuestionSpan{3, 1}));
    EXPECT_EQ(log.question_of("tiles", 5 * 2 + 3, 20), 3U);
    EXPECT_EQ(log.questions_of("tiles", 5 * 3 + 3, 20), (QuestionSpan{1, 3}));
    EXPECT_EQ(log.question_of("tiles", 5 * 3 + 3, 20), std::nullopt);
    EXPECT_EQ(log.questions_of("tiles", 5 * 2 + 4, 20), (QuestionSpan{0, 4})) << "beside the tiles";
    EXPECT_EQ(log.questions_of("no such value", 0, 1), QuestionSpan{});
}

TEST(QuestionLog, counts_the_rows_that_one_question_led_to)
{
    Questions questions({.questions = true});
    Recorder out(questions);
    out.append("two", 0.0F);
    for (int i = 0; i < 2; ++i) {
        const float twice = ask<sample::twice>(out, 7);
        out.append("two", twice);
        out.append("two", -twice);
    }
    out.finish();
    const QuestionLog log = read_questions(out.tensors());
    EXPECT_EQ(log.place_of_row("two", 0), (std::pair<std::size_t, std::size_t>(0, 0))) << "no question led to it";
    EXPECT_EQ(log.place_of_row("two", 3), (std::pair<std::size_t, std::size_t>(0, 2)));
    EXPECT_EQ(log.place_of_row("two", 4), (std::pair<std::size_t, std::size_t>(1, 2)));
    EXPECT_EQ(log.place_of_row("two", 5), (std::pair<std::size_t, std::size_t>(0, 0)));
    EXPECT_EQ(log.place_of_row("none", 0), (std::pair<std::size_t, std::size_t>(0, 0)));
}

TEST(QuestionLog, knows_what_numbers_that_are_none_mean)
{
    Questions questions({.questions = true});
    Recorder out(questions);
    (void)ask<sample::choose>(out, true, sample::Rule::nonzero, 2);
    out.finish();
    const QuestionLog log = read_questions(out.tensors());
    EXPECT_EQ(log.kinds.at(0).features, (std::vector<std::string>{"0", "1", "2"}));
    EXPECT_EQ(log.kinds.at(0).words,
              (std::vector<std::vector<std::string>>{{"false", "true"}, {"even_odd", "nonzero"}, {}}));
}

TEST(QuestionLog, holds_the_numbers_and_what_could_be_asked_instead)
{
    const QuestionLog log = log_of({.questions = true});
    ASSERT_EQ(log.kinds.size(), 2U);
    EXPECT_EQ(log.kinds[0].features, (std::vector<std::string>{"0.centre.x", "0.centre.y", "0.radius"}));
    EXPECT_EQ(log.kinds[0].questions.at(1), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(log.kind_of(2), &log.kinds[1]);
    EXPECT_EQ(log.kind_of(3), nullptr);
    const OtherQuestion halved{"umbral::sample::twice", "0", "halved", ""};
    EXPECT_NE(std::ranges::find(log.others, halved), log.others.end());
}

TEST(QuestionLog, leaves_out_what_does_not_fit_together)
{
    const auto text = [](std::string_view letters) {
        Tensor tensor{Element::uint8, static_cast<std::uint32_t>(letters.size()), 1, 1, {}, {}};
        for (const char letter : letters) tensor.bytes.push_back(static_cast<std::byte>(letter));
        return tensor;
    };
    Recorder::Tensors tensors;
    tensors["?code"] = text("no tab\nx\tno number\n7\tcode\n\n");
    tensors["?functions"] = text("f\ta\tb\n");
    tensors["?features 0"] = text("not a table");
    tensors["?rows t"] = text("not numbers");
    tensors["?whole p"] = Tensor{Element::uint32, 1, 1, 1, std::vector<std::byte>(4), {}};
    tensors["?others"] = text("f\tplace\n\n");
    const QuestionLog log = read_questions(tensors);
    EXPECT_EQ(log.code, (std::map<std::uint32_t, std::string>{{7, "code"}}));
    EXPECT_TRUE(log.kinds.at(0).questions.empty());
    EXPECT_EQ(log.question_of("t", 0, 1), std::nullopt);
    EXPECT_EQ(log.question_of("p", 0, 1), std::nullopt);
    EXPECT_TRUE(log.others.empty());
}

}
}
