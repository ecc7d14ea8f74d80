#pragma once

#include <string>
#include <vector>

#include "question/answer_patterns.hpp"

namespace umbral::grader::test {

/// The most telling pattern of these answers; empty if there is none.
inline std::string first_pattern(const AnswerTable& table)
{
    const std::vector<AnswerPattern> patterns = answer_patterns(table);
    return patterns.empty() ? "" : patterns.front().words;
}

}
