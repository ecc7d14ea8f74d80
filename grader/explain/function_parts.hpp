#pragma once

#include <list>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "explain/explained_checks.hpp"

namespace umbral::grader {

/// The answers of one function within a check.
struct PartOfCheck {
    const CaseChecks* group = nullptr;
    const Check* whole = nullptr;     ///< the check that they belong to
    FailingCheck part;                ///< as if these answers were all of it
    std::vector<std::size_t> rows{};  ///< of the check's table; none if it is all of the check
};

/// What is known of one function's answers.
struct AnswersOfOne {
    std::vector<PartOfCheck> parts;  ///< those that fail first
    std::size_t its_alone = 0;       ///< failing checks whose wrong rows are all of it
    bool beside_others = false;      ///< does any failing table hold rows of others, right or wrong?
};

/// Keeps what the parts point to.
struct FunctionParts {
    std::map<std::string, AnswersOfOne> functions;  ///< by their full names
    std::list<Check> checks;
    std::list<Tensor> tables;
    std::size_t failing = 0;  ///< checks that were taken apart
};

/// Takes checks apart by the function that was asked: tables row by row, as far as it is known of each row which
/// function was; of what is judged as a whole, as lists of events are, those for which only one function was asked.
/// Pictures and cases that crashed are left out.
[[nodiscard]] FunctionParts parts_by_function(Worker& worker, const Exercise& exercise,
                                              std::span<const CaseChecks> groups);

/// "Seen in rotate_x and rotate_y: your matrix …", of functions by their full names: where it shows, which is not
/// always where it is done.
[[nodiscard]] std::string sentence_about(const std::vector<std::string>& functions, std::string sentence);

}
