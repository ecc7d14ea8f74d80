#include "explain/question_code.hpp"

#include <fmt/format.h>

namespace umbral::grader {
namespace {

/// Of more that led to one picture the first and the last are shown.
constexpr std::uint32_t most_together = 6;

}

std::vector<std::uint32_t> shown_of(const QuestionSpan& span)
{
    std::vector<std::uint32_t> shown;
    const std::uint32_t left_out = span.count > most_together ? span.count - most_together : 0;
    for (std::uint32_t i = 0; i < span.count; ++i)
        if (i < most_together / 2 || i >= most_together / 2 + left_out) shown.push_back(span.first + i);
    return shown;
}

std::string together(const QuestionSpan& span, const std::map<std::uint32_t, std::string>& code)
{
    const std::vector<std::uint32_t> shown = shown_of(span);
    std::string text = span.count > 1 ? fmt::format("// {} calls in this order led to it\n", span.count) : "";
    for (const std::uint32_t question : shown) {
        const auto found = code.find(question);
        if (found == code.end()) return "";
        if (shown.size() < span.count && question == shown[most_together / 2])
            text += fmt::format("// … {} calls left out\n", span.count - shown.size());
        text += found->second;
        if (question != shown.back()) text += '\n';
    }
    return text;
}

}
