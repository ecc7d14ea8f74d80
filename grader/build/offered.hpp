#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "build/inspection.hpp"
#include "build/toolchain.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// What a unit may use of Umbral's own.
struct Offered {
    std::set<std::string> symbols;    ///< that the framework and the unit's `uses` define, mangled
    std::filesystem::path framework;  ///< the folder of the headers, without links
    std::set<std::string> headers;    ///< that its interfaces lead to by their includes: "umbral/raytracing/ray.hpp"
};

/// Reads it from the built project. Throws std::runtime_error if that is damaged.
[[nodiscard]] Offered offered_to(const Toolchain& tools, const Exercise& exercise);

/// The first function used that the header of another unit defines, as a sentence for the student: what helps to state
/// one unit can be the answer to another. What a header declares only is known by its symbol.
[[nodiscard]] std::optional<std::string> find_of_other_units(const Inspection& inspection, const Offered& offered);

}
