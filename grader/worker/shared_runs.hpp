#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "question/log.hpp"
#include "run/spawner.hpp"
#include "worker/made_once.hpp"

namespace umbral::grader {

/// What several workers remember together of trusted code. For use by several threads at once.
class SharedRuns {
public:
    using Texts = std::map<std::uint32_t, std::string>;  ///< of questions, by their numbers

    SharedRuns();

    MadeOnce<RunOutcome> runs;
    MadeOnce<RunOutcome> answers_to_others;  ///< questions in place of a case's own
    MadeOnce<QuestionLog> questions;
    MadeOnce<Texts> codes;  ///< of some questions of a case
};

}
