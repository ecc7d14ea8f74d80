#pragma once

#include <string_view>

namespace umbral::grader {

/// What became of a unit (or of one of its cases). A grader fault is never the student's zero.
enum class Verdict {
    ok,                  ///< all points
    partial,             ///< some points
    wrong,               ///< it ran, and earned nothing
    not_implemented,     ///< the stub is untouched, or reached in every case
    compile_error,       ///< the compiler refused it
    interface_mismatch,  ///< it compiles, but does not define what the header declares
    forbidden,           ///< it uses a name that the unit forbids, or one no student's file may use
    crashed,             ///< signal, assertion, uncaught exception
    timeout,             ///< over the time limit
    out_of_memory,       ///< over the memory limit
    blocked,             ///< the sandbox refused what it tried
    missing,             ///< the file was not handed in
    grader_fault,        ///< our fault: not scored
};

/// The name in JSON: "not_implemented".
[[nodiscard]] std::string_view to_string(Verdict verdict);
/// The same in words for people: "not implemented yet".
[[nodiscard]] std::string_view in_words(Verdict verdict);
/// Did no case run, so that listing checks would only repeat the verdict?
[[nodiscard]] bool never_ran(Verdict verdict);
/// The verdict of that JSON name. Throws std::invalid_argument for any other text.
[[nodiscard]] Verdict verdict_from(std::string_view name);

}
