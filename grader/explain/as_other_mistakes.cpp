#include "explain/as_other_mistakes.hpp"

#include "explain/explain_unit.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_mistakes = 3;  ///< of which it can be said
constexpr std::size_t most_mistakes = 9;
constexpr std::size_t most_drawn_mistakes = 3;  ///< where each draws by OpenGL

}

OtherMistakes::OtherMistakes(Worker& worker, const AskedCheck& asked)
    : worker_(worker), asked_(asked), mistakes_(explaining_mistakes(worker, asked.exercise))
{
}

bool OtherMistakes::most(const std::function<std::optional<bool>(const AskedCheck& mistake)>& is_so) const
{
    std::size_t tried = 0;
    std::size_t so = 0;
    for (const KnownSolution& mistake : mistakes_) {
        if (tried == (asked_.exercise.gl ? most_drawn_mistakes : most_mistakes)) break;
        const Built built = as_built(mistake);
        CaseResult one;
        one.hidden = asked_.result.hidden;
        one.seed = asked_.result.seed;
        // What was graded of a hidden case nobody asks again.
        if (!one.hidden) one.student = worker_.run(asked_.exercise, built, asked_.check.case_name, one.seed);
        CaseRuns runs(worker_, asked_.exercise, built, asked_.check.case_name, one);
        const std::optional<bool> said = is_so({asked_.exercise, asked_.check, runs, one, asked_.log, asked_.headers});
        tried += said ? 1 : 0;
        so += said.value_or(false) ? 1 : 0;
    }
    return tried >= least_mistakes && 2 * so > tried;
}

}
