#pragma once

#include <string_view>
#include <vector>

namespace umbral::grader {

/// Functions that do one thing, by where they are declared and how they are called: what a unit forbids when it forbids
/// `name`.
struct ForbiddenFamily {
    std::string_view name;                  ///< in manifests: "@transforms"
    std::string_view what;                  ///< for students: what the functions do
    std::vector<std::string_view> headers;  ///< patterns of the headers (below an include folder) that declare them
    std::vector<std::string_view> symbols;  ///< patterns of C names
    std::vector<std::string_view> except;   ///< functions of those headers that do something else
};

/// The families that manifests may name. Adding one is adding an entry.
[[nodiscard]] const std::vector<ForbiddenFamily>& forbidden_families();

/// The family of that name ("@transforms"), or null.
[[nodiscard]] const ForbiddenFamily* forbidden_family(std::string_view name);

/// Is this an entry that `forbid` may hold: a name or a pattern, or, if it begins with @, a known family?
[[nodiscard]] bool is_forbid_entry(std::string_view entry);

}
