#pragma once

#include <span>

#include "run/protocol.hpp"
#include "run/spawner.hpp"

namespace umbral::grader {

/// Reads what a dead run left and says how it ended. Pure: all that is hostile is in `recording` and `printed`.
/// `confined` says that the run reached its sandbox, so that the student's code may have run: without it a run ends by
/// the grader's fault; with it only if the machine was too short of memory to let it go on. Every text of the outcome
/// is made printable, bounded and free of the request's roots here, and nowhere else.
[[nodiscard]] RunOutcome judge_end(const protocol::Ended& ended, bool confined, std::span<const std::byte> recording,
                                   std::string_view printed, const RunRequest& request);

}
