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

/// The name of a unit's file of equivalents: "mutants.json", of slips "slips.json".
[[nodiscard]] std::string entries_file(MutantFamily family);

/// What that file in a unit's folder says: [{"line", "change", "reason"}, …]; none is an empty list. Throws
/// std::runtime_error that names the file and what was expected.
[[nodiscard]] std::vector<Equivalent> equivalents_of(const std::filesystem::path& unit, MutantFamily family);

/// Is this entry about that mutant of the source?
[[nodiscard]] bool is_about(const Equivalent& entry, const Mutant& mutant, const std::string& source);

}
