#include "explain/question_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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
    std::vector<std::string_view> texts;
    for (const std::uint32_t question : shown) {
        const auto found = code.find(question);
        if (found == code.end()) return "";
        texts.push_back(found->second);
    }
    const auto is_in_a_later_one = [&](std::size_t i) {
        return std::any_of(texts.begin() + static_cast<std::ptrdiff_t>(i) + 1, texts.end(),
                           [&](std::string_view later) {
                               return later != texts[i] && later.find(texts[i]) != std::string_view::npos;
                           });
    };
    std::string text = span.count > 1 ? fmt::format("// {} calls in this order led to it\n", span.count) : "";
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown.size() < span.count && i == most_together / 2)
            text += fmt::format("// … {} {} left out\n", span.count - shown.size(),
                                span.count - shown.size() == 1 ? "call" : "calls");
        if (is_in_a_later_one(i)) continue;
        text += texts[i];
        if (i + 1 < shown.size()) text += '\n';
    }
    return text;
}

}
