#pragma once

namespace umbral::grader {

/// Seconds of processor time that a process has taken up to now, with its children, those that ended and those that did
/// not. What the system does not tell counts nothing.
[[nodiscard]] double processor_seconds_of_tree(int process);

}
