#pragma once

#include <string>
#include <string_view>

namespace umbral::gl {

/// A compiler's log with "0:12(5): error: …" (Mesa) or "0(12) : error …" turned into "phong.frag:12: error: …", where
/// the student can find it.
///
/// Lines that name no place stay as they are; at most 20 lines are kept, and what is cut is said.
[[nodiscard]] std::string with_file_name(std::string_view log, std::string_view file);

}
