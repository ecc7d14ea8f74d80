#include "model/verdict.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "message_of.hpp"

namespace umbral::grader {
namespace {

constexpr int verdicts = static_cast<int>(Verdict::grader_fault) + 1;

TEST(Verdict, every_name_is_its_own_and_leads_back)
{
    std::set<std::string_view> names;
    std::set<std::string_view> words;
    for (int i = 0; i < verdicts; ++i) {
        const auto verdict = static_cast<Verdict>(i);
        names.insert(to_string(verdict));
        words.insert(in_words(verdict));
        EXPECT_EQ(verdict_from(to_string(verdict)), verdict);
    }
    EXPECT_EQ(names.size(), std::size_t{verdicts});
    EXPECT_EQ(words.size(), std::size_t{verdicts});
}

TEST(Verdict, has_the_documented_names)
{
    EXPECT_EQ(to_string(Verdict::not_implemented), "not_implemented");
    EXPECT_EQ(in_words(Verdict::not_implemented), "not implemented yet");
    EXPECT_EQ(verdict_from("out_of_memory"), Verdict::out_of_memory);
}

TEST(Verdict, refuses_other_texts_and_numbers)
{
    for (const char* text : {"", "OK", "ok ", "passed"})
        EXPECT_THROW((void)verdict_from(text), std::invalid_argument) << text;
    EXPECT_NE(test::message_of([] { (void)verdict_from("passed"); }).find("grader_fault, got 'passed'"),
              std::string::npos);
    EXPECT_THROW((void)to_string(static_cast<Verdict>(verdicts)), std::invalid_argument);
}

}
}
