#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace umbral::grader {

/// The first line of a compiler's assembler text that C++ alone does not lead to: assembler that was written by hand,
/// which compilers put behind "#APP"; a directive that they never write, as `.incbin`; a section of another kind; or
/// several statements in a line, as names that hold line feeds would leave them. GCC and Clang, for x86-64 and AArch64.
///
/// Before it stands its place, "a.cpp:12: ", where the compiler writes that down.
///
/// Looks at what is assembled, so it holds whatever way assembler took into the source. Linear in the size of the text.
[[nodiscard]] std::optional<std::string> find_foreign_assembler(std::string_view text);

/// What umbral-as says before such a line.
inline constexpr std::string_view assembler_refused = "umbral-as: assembler is not allowed: ";

}
