#pragma once

#include <optional>
#include <string>
#include <vector>

#include "build/builder.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// The only case of the driver that is made of a pasted question.
inline constexpr const char* asked_case = "question";

/// What one solution answers.
struct Answer {
    bool given = false;                ///< false: the run was stopped, as `text` says
    std::string text;                  ///< as code, printable; or what stopped it
    std::vector<std::string> names{};  ///< of the numbers in the answer: "origin.x"; empty for the answer itself
    std::vector<double> numbers{};
};

/// What all solutions answer to one question.
struct AskedQuestion {
    std::string refused{};  ///< why nobody was asked, for people: the compiler's message; or empty
    Answer yours;
    Answer reference;
    std::optional<Answer> oracle;  ///< of units that have one
};

/// Why questions cannot be asked of this unit, in words; empty if they can.
[[nodiscard]] std::string not_askable(const Exercise& exercise);

/// Asks one question, as reports show it: a call of the unit's functions with all its arguments, or lines that make
/// objects and then one on them. It becomes a driver of one case, compiled and run in the confinement of a student's
/// own files. Throws std::runtime_error for faults of the grader's.
[[nodiscard]] AskedQuestion ask_question(Worker& worker, const Exercise& exercise, const Built& built,
                                         const std::string& question);

}
