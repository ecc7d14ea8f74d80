#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mutants/mutant.hpp"

namespace umbral::grader {

/// A mutant that survives because no user could tell it from the reference.
struct Equivalent {
    std::string line;    ///< the source's line without the space round it
    std::string change;  ///< as in Mutant: "a < b → a <= b"
    std::string reason;
};

/// The file mutants.json of a unit's folder: [{"line", "change", "reason"}, …]; none is an empty list. Throws
/// std::runtime_error that names the file and what was expected.
[[nodiscard]] std::vector<Equivalent> equivalents_of(const std::filesystem::path& unit);

/// Is this entry about that mutant of the source?
[[nodiscard]] bool is_about(const Equivalent& entry, const Mutant& mutant, const std::string& source);

}
