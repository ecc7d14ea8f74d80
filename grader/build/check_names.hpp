#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "build/inspection.hpp"
#include "build/submission.hpp"
#include "model/exercise.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// Why a built library may not run.
struct Objection {
    Verdict verdict;
    std::string message;
};

/// Does the library define all of `interface` (mangled), and want only what is allowed or in `offered` (mangled)? Does it use none of
/// the exercise's forbidden names?
[[nodiscard]] std::optional<Objection> object_to(const Inspection& inspection, const std::vector<std::string>& interface_names,
                                                 const std::set<std::string>& offered, const Exercise& exercise);

/// The same for GLSL: forbidden names among the words outside comments.
[[nodiscard]] std::optional<Objection> object_to_words(const Sources& files, const Exercise& exercise);

}
