#include "question/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

#include "question/names.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

/// Is it no class's member? Then it makes objects.
bool is_factory(std::string_view function)
{
    const std::size_t end = function.rfind("::");
    if (end == std::string_view::npos) return true;
    const std::string_view owner = reflect::last_name(function.substr(0, end));
    return owner.empty() || std::isupper(static_cast<unsigned char>(owner.front())) == 0;
}

/// The last of these questions before this one.
std::optional<std::uint32_t> last_before(const QuestionKind& kind, std::uint32_t question)
{
    const auto next = kind.questions.lower_bound(question);
    return next == kind.questions.begin() ? std::nullopt : std::optional(std::prev(next)->first);
}

}

History::History(const QuestionLog& log, const std::string& function)
{
    const auto found = log.histories.find(function);
    if (found == log.histories.end()) return;
    for (const QuestionKind& kind : log.kinds)
        if (kind.function != function && std::ranges::find(found->second, kind.function) != found->second.end())
            changing_.push_back(&kind);
    std::set<std::uint32_t> answering;
    for (const auto& [value, questions] : log.rows)
        for (const std::uint32_t question : questions)
            if (question > 0) answering.insert(question - 1);
    for (const QuestionKind* const kind : changing_)
        for (const auto& [question, numbers] : kind->questions)
            if (is_factory(kind->function) && !answering.contains(question)) made_.push_back(question);
    std::ranges::sort(made_);
}

std::vector<std::string> History::names(const std::string& headers) const
{
    std::vector<std::string> names;
    for (const QuestionKind* const kind : changing_) {
        const std::vector<std::string> parameters = parameter_names(headers, kind->function);
        for (const std::string& place : kind->features)
            names.push_back(fmt::format("{} of {}", in_words(place, parameters), reflect::last_name(kind->function)));
    }
    if (!changing_.empty()) names.emplace_back("the last change before it");
    return names;
}

std::vector<std::vector<std::string>> History::words() const
{
    std::vector<std::vector<std::string>> words;
    std::vector<std::string> functions{"none"};
    for (const QuestionKind* const kind : changing_) {
        for (std::size_t i = 0; i < kind->features.size(); ++i)
            words.push_back(i < kind->words.size() ? kind->words[i] : std::vector<std::string>());
        functions.emplace_back(reflect::last_name(kind->function));
    }
    if (!changing_.empty()) words.push_back(std::move(functions));
    return words;
}

std::vector<double> History::numbers(std::uint32_t question) const
{
    const auto next_made = std::ranges::lower_bound(made_, question);
    const std::uint32_t made = next_made == made_.begin() ? 0 : *std::prev(next_made);
    std::vector<double> numbers;
    std::optional<std::uint32_t> latest;
    double which = 0;
    for (std::size_t i = 0; i < changing_.size(); ++i) {
        const QuestionKind& kind = *changing_[i];
        const std::optional<std::uint32_t> last = last_before(kind, question);
        if (!last || *last < made) {
            numbers.resize(numbers.size() + kind.features.size(), std::nan(""));
            continue;
        }
        const std::vector<double>& its = kind.questions.at(*last);
        numbers.insert(numbers.end(), its.begin(), its.end());
        if (latest && *latest > *last) continue;
        latest = last;
        which = static_cast<double>(i + 1);
    }
    if (!changing_.empty()) numbers.push_back(which);
    return numbers;
}

}
