#pragma once

#include <optional>
#include <string>
#include <vector>

#include "build/inspection.hpp"
#include "build/offered.hpp"
#include "build/submission.hpp"
#include "model/exercise.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// Why a built library may not run.
struct Objection {
    Verdict verdict;
    std::string message;
};

/// Does the library define the whole interface, want only what is allowed or in `offered`, and use nothing that the
/// exercise forbids, or that belongs to other units?
[[nodiscard]] std::optional<Objection> object_to(const Inspection& inspection, const Offered& offered,
                                                 const Exercise& exercise);

/// The same for GLSL: forbidden names among the words outside comments.
[[nodiscard]] std::optional<Objection> check_words(const Sources& files, const Exercise& exercise);

}
