#pragma once

#include <string>

#include "worker/worker.hpp"

namespace umbral::grader {

/// The text of the headers where a unit's parameters have names: its own first, since other units' functions may have
/// the names of its own, then the rest of its topic's.
[[nodiscard]] std::string interface_text(const Worker& worker, const Exercise& exercise);

}
