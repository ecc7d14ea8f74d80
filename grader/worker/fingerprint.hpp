#pragma once

#include <vector>

#include "model/scorecard.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What results on this machine depend on: starts the spawners that `exercises` need and asks them what protects and
/// what draws.
[[nodiscard]] Fingerprint fingerprint(Worker& worker, const std::vector<Exercise>& exercises);

/// The first line that a program prints for `--version`; empty if it cannot be run.
[[nodiscard]] std::string version_of(const std::string& program);

}
