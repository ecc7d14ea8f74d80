#include "explain/as_other_mistakes.hpp"

#include "explain/explain_unit.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_mistakes = 3;  ///< of which it can be said
constexpr std::size_t most_mistakes = 9;
constexpr std::size_t most_drawn_mistakes = 3;  ///< where each draws by OpenGL

}

struct OtherMistakes::HandedIn {
    Built built;
    CaseResult result;
    CaseRuns runs;

    HandedIn(Worker& worker, const AskedCheck& asked, const KnownSolution& mistake)
        : built(as_built(mistake)), runs(worker, asked.exercise, built, asked.check.case_name, result)
    {
        result.hidden = asked.result.hidden;
        result.seed = asked.result.seed;
        // What was graded of a hidden case nobody asks again.
        if (!result.hidden) result.student = worker.run(asked.exercise, built, asked.check.case_name, result.seed);
    }
};

OtherMistakes::OtherMistakes(Worker& worker, const AskedCheck& asked)
    : worker_(worker), asked_(asked), mistakes_(explaining_mistakes(worker, asked.exercise))
{
}

OtherMistakes::~OtherMistakes() = default;

bool OtherMistakes::most(const std::function<std::optional<bool>(const AskedCheck& mistake)>& is_so)
{
    std::size_t tried = 0;
    std::size_t so = 0;
    auto handed_in = handed_in_.begin();
    for (const KnownSolution& mistake : mistakes_) {
        if (tried == (asked_.exercise.gl ? most_drawn_mistakes : most_mistakes)) break;
        if (handed_in == handed_in_.end()) handed_in = handed_in_.emplace(handed_in, worker_, asked_, mistake);
        HandedIn& one = *handed_in++;
        const std::optional<bool> said =
            is_so({asked_.exercise, asked_.check, one.runs, one.result, asked_.log, asked_.headers});
        tried += said ? 1 : 0;
        so += said.value_or(false) ? 1 : 0;
    }
    return tried >= least_mistakes && 2 * so > tried;
}

}
