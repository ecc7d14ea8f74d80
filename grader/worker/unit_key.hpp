#pragma once

#include <map>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "collect/handed.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// What a whole class's results depend on beside the submissions.
struct KeyPlan {
    Fingerprint fingerprint;
    Grading grading;
    bool explain = true;
    bool instructor_edition = false;
};

/// Tells whether a result that was kept is still the answer: equal keys, equal results. Looks at the files of the
/// installation (by size and time of their last change) once, when it is made.
class UnitKeys {
public:
    UnitKeys(const Toolchain& tools, const std::vector<Exercise>& exercises, const KeyPlan& plan);

    /// SHA-256 over all that decides the result of one of the exercises for what a student handed in.
    [[nodiscard]] std::string key(const Exercise& exercise, const std::string& student, const Handed& handed) const;

    /// … and over all of that but what the student handed in.
    [[nodiscard]] const std::string& of_unit(const Exercise& exercise) const { return by_unit_.at(exercise.id); }

    /// SHA-256 over all that decides how a submission's report looks, given its results and titles.
    [[nodiscard]] const std::string& of_reports() const noexcept { return reports_; }

private:
    std::map<std::string, std::string> by_unit_;
    std::string reports_;
};

/// Digest of version and machine; without OpenGL, which only some units use.
[[nodiscard]] std::string machine_digest(const Fingerprint& fingerprint);

}
