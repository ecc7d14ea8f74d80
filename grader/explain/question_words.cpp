#include "explain/question_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "question/names.hpp"
#include "text/joined.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {

std::vector<std::string> functions_of(const OtherQuestion& question)
{
    std::vector<std::string> all{question.function};
    for (const OtherPlace& one : question.also)
        if (std::ranges::find(all, one.function) == all.end()) all.push_back(one.function);
    return all;
}

std::string in_words(const OtherQuestion& question, const std::string& headers)
{
    if (question.change == left_out) {
        std::vector<std::string> functions = functions_of(question);
        for (std::string& function : functions) function = reflect::last_name(function);
        return fmt::format("all calls of {} left out", joined_with_and(functions));
    }
    const auto words_of = [&](const std::string& function, const std::string& place) {
        if (function.empty()) return std::string(reflect::last_name(place));
        return in_words(place, parameter_names(headers, function));
    };
    std::vector<std::string> places{words_of(question.function, question.place)};
    for (const OtherPlace& one : question.also)
        if (std::string words = words_of(one.function, one.place); std::ranges::find(places, words) == places.end())
            places.push_back(std::move(words));
    if (question.other.empty()) {
        std::string change = question.change;
        if (const std::size_t its = change.find(" its "); places.size() > 1 && its != std::string::npos)
            change.replace(its, 5, " their ");
        return fmt::format("{} {}", joined_with_and(places), change);
    }
    const std::string other = words_of(question.function, question.other);
    if (question.change.empty()) return fmt::format("{} and {} exchanged", places.front(), other);
    return fmt::format("{} {} {}", places.front(), question.change, other);
}

std::string sentence(const OtherQuestion& question, const std::string& words)
{
    if (question.function.empty())
        return fmt::format(
            "Your results are the right ones for other questions: with {} in all of them. Look at how "
            "your code uses what it is given.",
            words);
    if (question.change == left_out)
        return fmt::format("Your results are the right ones with {}. Look at what they should change.", words);
    std::vector<std::string> functions = functions_of(question);
    for (std::string& function : functions) function = reflect::last_name(function);
    return fmt::format(
        "Your results are the right ones for {}: {} with {}. Look at how your code uses what it is given.",
        functions.size() > 1 ? "other questions" : "another question", joined_with_and(functions), words);
}

}
