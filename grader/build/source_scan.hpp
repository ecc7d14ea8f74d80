#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace umbral::grader {

/// The first character or string of preprocessed C++ that is not closed in its line, or a character of many letters,
/// with its place: no compiler takes it, and what is read from there on might be read otherwise. Linear in the size of
/// the text.
[[nodiscard]] std::optional<std::string> find_unclosed(std::string_view text);

/// Looks through preprocessed C++ for what would reach the assembler as text: inline and top-level assembler,
/// attributes and directives whose strings the compiler writes out as they are, and attributes that switch
/// instrumentation off. With those, a file could write debug information of its own, rename or hide what it calls, or
/// leave its work uncounted. And for the linker's own names, such as _GLOBAL_OFFSET_TABLE_: they lead to the tables of
/// all libraries, where functions are found that may not be called by name.
///
/// `text` is what `g++ -E -fpch-preprocess` printed, of one file or of several in a row: macros are expanded and tokens
/// pasted, so that nothing can be spelt another way. Plain names in asm labels are allowed, since the C library's own
/// headers use them; so is the assembler of the compiler's <immintrin.h>. `header` is the one precompiled header that
/// the text may ask for.
///
/// Returns what is not allowed, with its place, for the student; nothing if all is well. Linear in the size of the
/// text.
[[nodiscard]] std::optional<std::string> find_assembler(std::string_view text, std::string_view header);

}
