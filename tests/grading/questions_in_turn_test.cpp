#include <gtest/gtest.h>

#include "explain/question_words.hpp"
#include "explain/questions_in_turn.hpp"

// Which questions are asked in place of a case's, in which order, and what they are called.
namespace umbral::grader {
namespace {

/// As a run of a driver tells them, in the order of the arguments.
void add_part(QuestionLog& log, const std::string& function, const std::string& place, const std::string& field,
              const std::vector<std::string>& changes)
{
    for (const std::string& change : changes) {
        log.others.push_back({function, place, change, ""});
        if (!field.empty()) log.others.push_back({"", field, change, ""});
    }
}

std::vector<std::string> in_order(const QuestionLog& log, const std::string& headers)
{
    std::vector<std::string> words;
    for (const QuestionInTurn& one : questions_in_turn(log, headers)) words.push_back(in_words(one.question, headers));
    return words;
}

constexpr const char* paint = "struct Paint { float thick; float thin; };\nfloat cover(const Paint& paint, int coats);";

TEST(QuestionsInTurn, every_part_has_its_turn_before_another_has_two)
{
    QuestionLog log;
    add_part(log, "umbral::cover", "0.thick", "umbral::Paint.thick", {"negated", "doubled", "halved"});
    log.others.push_back({"umbral::cover", "0.thick", "taken as", "0.thin"});
    log.others.push_back({"", "umbral::Paint.thick", "taken as", "umbral::Paint.thin"});
    log.others.push_back({"umbral::cover", "0.thick", "", "0.thin"});
    add_part(log, "umbral::cover", "0.thin", "umbral::Paint.thin", {"negated", "doubled", "halved"});
    add_part(log, "umbral::cover", "1", "", {"one larger"});
    EXPECT_EQ(
        in_order(log, paint),
        (std::vector<std::string>{"paint.thick negated", "paint.thin negated", "coats one larger",
                                  "paint.thick taken as paint.thin", "paint.thin doubled", "paint.thick doubled",
                                  "paint.thin halved", "paint.thick and paint.thin exchanged", "paint.thick halved"}));
}

TEST(QuestionsInTurn, a_field_of_one_function_only_is_asked_once)
{
    QuestionLog log;
    add_part(log, "umbral::cover", "0.thick", "umbral::Paint.thick", {"negated"});
    const std::vector<QuestionInTurn> once = questions_in_turn(log, paint);
    ASSERT_EQ(once.size(), 1U);
    EXPECT_EQ(once.front().everywhere, (OtherQuestion{"", "umbral::Paint.thick", "negated", ""}));
    add_part(log, "umbral::mix", "1.thick", "umbral::Paint.thick", {"negated"});
    const std::vector<QuestionInTurn> several = questions_in_turn(log, paint);
    EXPECT_EQ(several.size(), 3U);
    for (const QuestionInTurn& one : several) EXPECT_FALSE(one.everywhere);
}

TEST(QuestionsInTurn, what_is_called_alike_in_the_history_of_an_object_is_changed_together)
{
    const std::string headers =
        "class Lamp { virtual void turn(float angle, bool fast) = 0; virtual float light() const = 0; };\n"
        "std::unique_ptr<Lamp> make_lamp(int watts, float angle);\nfloat other(float angle);";
    QuestionLog log;
    log.histories["umbral::Lamp::light"] = {"umbral::Lamp::turn", "umbral::make_lamp"};
    for (const auto& [function, place] :
         {std::pair("umbral::make_lamp", "1"), std::pair("umbral::Lamp::turn", "0"), std::pair("umbral::other", "0")})
        log.others.push_back({function, place, "negated", ""});
    const std::vector<QuestionInTurn> all = questions_in_turn(log, headers);
    ASSERT_EQ(all.size(), 4U);
    const OtherQuestion& together = all.back().question;
    EXPECT_EQ(together, (OtherQuestion{"umbral::make_lamp", "1", "negated", "", {{"umbral::Lamp::turn", "0"}}}));
    EXPECT_EQ(sentence(together, in_words(together, headers)),
              "Your results are the right ones for other questions: make_lamp and turn with angle negated. Look at how "
              "your code uses what it is given.");
    EXPECT_TRUE(may_change(log, "umbral::make_lamp", "umbral::Lamp::light"));
    EXPECT_FALSE(may_change(log, "umbral::other", "umbral::Lamp::light"));
    EXPECT_TRUE(may_change(log, "umbral::other", "umbral::other"));
}

TEST(QuestionsInTurn, arguments_of_one_kind_are_changed_together)
{
    const std::string headers = "void drag(float right, float up);";
    QuestionLog log;
    for (const char* const place : {"0", "1"}) log.others.push_back({"umbral::drag", place, "doubled", ""});
    EXPECT_EQ(in_order(log, headers),
              (std::vector<std::string>{"right doubled", "up doubled", "right and up doubled"}));
    log.others.push_back({"umbral::drag", "2.x", "doubled", ""});
    EXPECT_EQ(in_order(log, headers).size(), 3U) << "an argument that only parts of can be changed";
}

TEST(QuestionsInTurn, the_simpler_of_two_reasons_is_less_far_fetched)
{
    const OtherQuestion exchanged{"f", "0", "", "1"};
    const OtherQuestion negated{"f", "0", "negated", ""};
    const OtherQuestion taken{"f", "0", "taken as", "1"};
    const OtherQuestion copied{"f", "0", "with y taken as x", ""};
    const OtherQuestion zero{"f", "0", "taken as 0", ""};
    const OtherQuestion both{"f", "0", "negated", "", {{"f", "1"}}};
    EXPECT_LT(far_fetched(zero), far_fetched(negated));
    EXPECT_LT(far_fetched(exchanged), far_fetched(taken));
    EXPECT_LT(far_fetched(negated), far_fetched(copied));
    EXPECT_EQ(far_fetched(taken), far_fetched(copied));
    EXPECT_LT(far_fetched(taken), far_fetched(both));
}

}
}
