#pragma once

#include <functional>
#include <list>
#include <optional>
#include <vector>

#include "explain/asked_answers.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {

/// The unit's known mistakes beside a student's work: what is so of wrong answers whatever the mistake is, as where
/// hardly anything is left to be done wrong, says nothing of the one at hand.
class OtherMistakes {
public:
    /// Both must live as long.
    OtherMistakes(Worker& worker, const AskedCheck& asked);
    ~OtherMistakes();

    /// Is it so of more than half of the mistakes, as if each were the student's work? `is_so` gets the check as asked
    /// of a mistake, and says nothing where nothing is wrong with it. Few mistakes are tried, and with fewer than three
    /// of which it can be said, it is not so.
    [[nodiscard]] bool most(const std::function<std::optional<bool>(const AskedCheck& mistake)>& is_so);

private:
    /// A mistake's runs, each made once for all that is asked of it.
    struct HandedIn;

    Worker& worker_;
    const AskedCheck& asked_;
    std::vector<KnownSolution> mistakes_;
    std::list<HandedIn> handed_in_;  ///< the first of them
};

}
