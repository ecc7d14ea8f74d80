#pragma once

#include <span>
#include <string>
#include <string_view>

namespace umbral::grader {

/// Text that comes out of a run, without the paths of this machine: each of `roots` (absolute folders; the longest that
/// fits counts) is taken away where a path begins with it, so that "/home/ann/.cache/umbral/builds/ab/student.so: …"
/// becomes "student.so: …".
[[nodiscard]] std::string without_roots(std::string_view text, std::span<const std::string> roots);

}
