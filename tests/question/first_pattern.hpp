#pragma once

#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader::test {

using Row = std::vector<double>;

/// Right answers of one to `components` numbers, and wrong ones made of them.
template <class Wrong>
AnswerTable table(std::size_t components, Wrong wrong, std::size_t rows = 1)
{
    AnswerTable made{components, 0, {}, {}, {}};
    if (components > 1) made.columns = {"x", "y", "z"};
    for (int i = 0; i < 12; ++i) {
        Row right;
        for (std::size_t at = 0; at < rows * components; ++at) right.push_back(i + 10 * static_cast<double>(at) + 1);
        const bool is_wrong = i % 2 == 0;
        made.answers.push_back({is_wrong ? wrong(right) : right, right, is_wrong});
    }
    return made;
}

/// The most telling pattern of these answers; empty if there is none.
inline std::string first_pattern(const AnswerTable& table)
{
    const std::vector<AnswerPattern> patterns = answer_patterns(table);
    return patterns.empty() ? "" : patterns.front().words;
}

}
