#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "explain/asked_answers.hpp"
#include "question/answer_patterns.hpp"
#include "question/facts.hpp"

namespace umbral::grader {

/// What the right answer's numbers, and whether there is one, are called among those of a question.
inline constexpr const char* right_answer = "the right answer";
inline constexpr const char* length_of_answer = "the right answer's length";  ///< of a list: its rows
inline constexpr const char* has_answer = "there being a right answer";
/// Of a question with several answers, where an answer stands among them.
inline constexpr const char* place_in_call = "a row of a call";

/// Questions or answers beside each other: what is told of each, and which are wrong.
struct ToldSample {
    std::vector<std::string> names{};  ///< of the numbers
    std::vector<std::vector<double>> numbers{};
    std::vector<Fact> facts{};
    std::vector<bool> wrong{};
};

/// A check's answers whose questions are of one kind, the kind that most wrong ones have.
struct AskedSample {
    std::string function{};  ///< that was asked; empty if that is not known
    AnswerTable answers{};
    /// Where a question has several answers, which are compared one by one: these together, as one list each. A first
    /// row that only counts the others is not in it.
    AnswerTable lists{};
    std::set<std::vector<double>> questions{};  ///< the numbers of all
    /// Each answer by itself, in the same order, with its question's numbers and the right answer's. Where a question
    /// has several answers, they tell no more of it than one would: then without the question's, but with the answer's
    /// place among them.
    ToldSample by_answer{};
    /// Where a question has several answers, else empty: each question once, wrong if one of its answers is. Of the
    /// right answers it holds only whether there is one.
    ToldSample by_question{};
    std::vector<AnswerPair> others_wrong{};  ///< the wrong answers whose questions are of other kinds
};

/// The answers with the inputs of a seed, but for those to questions that `but` holds. The student's code may be run
/// again.
[[nodiscard]] AskedSample asked_sample(Worker& worker, const AskedCheck& asked, std::uint64_t seed,
                                       const AskedSample* but = nullptr);

/// Adds the answers of another seed. False, and nothing is changed, if other things are told of them.
[[nodiscard]] bool add(AskedSample& sample, const AskedSample& other);

}
