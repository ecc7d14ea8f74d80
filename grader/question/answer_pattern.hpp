#pragma once

#include <string>
#include <string_view>

#include "model/common_tells.hpp"

namespace umbral::grader {

/// Something that all wrong answers share, in words that hold for answers to other questions too.
struct AnswerPattern {
    std::string words;  ///< they follow "every wrong answer", or "most wrong answers" of CommonTells::mostly
    CommonTells tells = CommonTells::other;
    bool of_question = false;  ///< they tell by which of a question's own numbers wrong answers are known

    friend bool operator==(const AnswerPattern&, const AnswerPattern&) = default;
    friend bool operator==(const AnswerPattern& one, std::string_view words) { return one.words == words; }
};

}
