#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// A sentence that a report says of a bug, and what became of it with inputs that it was not found on.
struct ToldSentence {
    enum class Truth : std::uint8_t {
        holds,    ///< with all inputs on which it could be tried
        fails,    ///< with some
        untried,  ///< there were none: with other inputs the bug does not show
    };
    enum class Kind : std::uint8_t {
        reason,      ///< "your results are the right ones for twice the angle", or the hint of a known mistake
        condition,   ///< "wrong wherever ray.t_min is positive"
        answer,      ///< "every wrong answer is always 0"
        dependence,  ///< "your wrong answers change with box.left, and the right ones do not"
        change,      ///< "asked with material.specular taken as 0, your answers are right"
        place        ///< "sphere.cpp:17": holds if that is the changed line or one of two beside it
    };
    Kind kind = Kind::reason;
    std::string check{};  ///< of what is said of one check
    std::string words{};
    Truth truth = Truth::untried;
};

/// Work with a bug that no author foresaw: the reference with one or two small changes of its source.
struct UnforeseenBug {
    std::string unit;
    std::string bug;  ///< "line 31: a < b → a <= b", two of them joined by "; "
    bool two = false;
    bool stopped = false;       ///< every failing case crashed, hung or was refused: there are no values to explain
    bool has_question = false;  ///< a failing check shows what was asked where it first differs
    std::vector<ToldSentence> said{};
};

/// What is tried.
struct UnforeseenPlan {
    unsigned bugs = 8;   ///< a unit, that lose points and are tried alone …
    unsigned pairs = 2;  ///< … and pairs of changes
    unsigned seed = 0;   ///< which of a reference's mutants, and with which inputs
};

/// Makes such bugs of one unit, in C++, by the program `finder` (umbral-mutate), grades each as a submission is graded,
/// and tries what its report says with the inputs of two other seeds: a reason must be given there again, a condition
/// part wrong answers from right ones. Throws std::runtime_error if the mutants cannot be built.
[[nodiscard]] std::vector<UnforeseenBug> explain_unforeseen(Worker& worker, const Exercise& exercise,
                                                            const std::filesystem::path& finder,
                                                            const UnforeseenPlan& plan);

/// How many bugs get a true sentence about what or where, how many a false one, in all units and in the half held out;
/// then every false sentence, and every bug of which nothing was said.
[[nodiscard]] std::string unforeseen_table(const std::vector<UnforeseenBug>& bugs);

/// At least 65 % of the bugs that leave values get a true sentence, and fewer than 1 % a false one.
[[nodiscard]] bool meets_targets(const std::vector<UnforeseenBug>& bugs);

}
