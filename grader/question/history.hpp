#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "question/log.hpp"

namespace umbral::grader {

/// What was done before a question to objects that it asks: the numbers in the last call of each function that makes
/// or changes them. What was done before the last object was made tells nothing of it; a call that answers a row of its
/// own was none that made it.
class History {
public:
    /// Of the questions to this function; no columns if it asks no objects. The log must outlive this.
    History(const QuestionLog& log, const std::string& function);

    /// What the columns are called, each behind its function's parameter names: "b_degrees of set_angles", and last
    /// "the last change before it".
    [[nodiscard]] std::vector<std::string> names(const std::string& headers) const;
    /// What 0, 1, … of each column mean, as QuestionKind::words.
    [[nodiscard]] std::vector<std::vector<std::string>> words() const;
    /// The numbers of one question, in the order of names(); NaN where there was no such call.
    [[nodiscard]] std::vector<double> numbers(std::uint32_t question) const;

private:
    std::vector<const QuestionKind*> changing_;  ///< calls that make or change objects, each kind by itself
    std::vector<std::uint32_t> made_;            ///< questions that made objects, in order
};

}
