#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "unit/grade_unit.hpp"

namespace umbral::grader {

/// One thing that must hold of a unit, and whether it did with one seed.
struct Finding {
    std::string unit;
    std::string subject;  ///< "reference", "alternative: double_precision", "mistake: far_root", "control: zeros",
                          ///< "stub", "statements", "case: random", "rubric: line 2", "columns: random/t",
                          ///< "fixed inputs"
    unsigned seed = 0;
    bool holds = false;
    double credit = 0;     ///< percent of the unit's points
    std::string expected;  ///< "100", "75..85", "forbidden"
    std::string message;   ///< what is wrong; the explanation found, for a mistake
    std::string what{};    ///< a solution's own words: what is wrong with a mistake, how an alternative differs
    std::string hint{};    ///< a mistake's, for the student
    std::optional<double>
        hard_share{};  ///< percent of the points of hard checks, where the unit has some and the subject ran
    std::vector<std::string>
        blind{};  ///< of a mistake: checks of pictures on which it draws the expected picture, bit by bit
};

/// Students read one of two statements, README.md and README.es.md: are both there?
[[nodiscard]] Finding expect_statements(const Exercise& exercise, unsigned seed);

/// Lies the reference, or each of its shaders, where the build looks for it below the folder `reference`? The message
/// names what was expected.
[[nodiscard]] Finding expect_reference(const std::filesystem::path& reference, const Exercise& exercise, unsigned seed);

/// Whether a unit's known mistakes are graded: most of the time that a unit takes.
enum class KnownMistakes { graded, passed_over };

/// Proves that a unit's checks discriminate, with the inputs of one seed: the reference and every alternative get all
/// points, the stub, every control and the forger none, each number of a row counts, every mistake its declared share,
/// told by its own hint; of a rubric each line has a mistake that costs points there and in no other line; the
/// reference is within its guarantee of the oracle; few of the points hang on inputs that never change. A mistake that
/// no check tells from the reference fails the unit; scenes that cannot show it are named (Finding::blind). Calls
/// `report` with each finding as it is made; with those of statements, reference and cases only if one is missing.
/// Without a reference, or where it finishes not all cases that the checks name, nothing else is looked at.
void validate_unit(Worker& worker, const Exercise& exercise, unsigned seed,
                   const std::function<void(const Finding&)>& report, KnownMistakes mistakes = KnownMistakes::graded);

}
