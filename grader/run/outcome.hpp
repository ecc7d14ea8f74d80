#pragma once

#include <span>

#include "run/protocol.hpp"
#include "run/spawner.hpp"

namespace umbral::grader {

/// Reads what a dead run left and says how it ended. Pure: all that is hostile is in `recording` and `printed`. `confined` says that the
/// run reached its sandbox, so that the student's code may have run: only without it can a run end by the grader's fault.
[[nodiscard]] RunOutcome judge_end(const protocol::Ended& ended, bool confined, std::span<const std::byte> recording, std::string_view printed,
                                   const Limits& limits);

}
