#pragma once

#include <span>

#include "run/protocol.hpp"
#include "run/spawner.hpp"

namespace umbral::grader {

/// Reads what a dead run left and says how it ended. Pure: all that is hostile is in `recording` and `printed`.
[[nodiscard]] RunOutcome judge_end(const protocol::Ended& ended, std::span<const std::byte> recording, std::string_view printed, const Limits& limits);

}
