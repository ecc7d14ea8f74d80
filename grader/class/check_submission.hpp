#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scorecard.hpp"
#include "worker/crew.hpp"
#include "worker/unit_key.hpp"

namespace umbral::grader {

/// How a student's own workspace is checked.
struct CheckPlan {
    std::filesystem::path folder;  ///< the workspace
    unsigned attempt = 0;          ///< another number gives other random inputs
    bool explain = true;
    bool pages = false;  ///< make the sections of the report's page too
    bool fresh = false;  ///< ask again, also where nothing has changed
};

/// A checked workspace.
struct Checked {
    SubmissionResult result;            ///< what the student may see
    Fingerprint fingerprint;            ///< of the machine it was checked on
    std::vector<std::string> sections;  ///< for html::report_from_sections, one a unit, if asked for
    std::size_t kept = 0;  ///< so many units were as they had been at the last check, and were not run again
};

/// Checks units of a workspace, on all workers of the crew. Of each unit the last result is kept in the user's cache,
/// under the digest of all that decides it (UnitKeys): unchanged files give it again at once, if the pictures that it
/// names still lie there. What comes out by chance of the machine (a fault, a run that starved) is asked again. Throws
/// as read_submission does.
[[nodiscard]] Checked check_submission(Crew& crew, const std::vector<Exercise>& exercises, const CheckPlan& plan);

/// From now on the crew keeps trusted runs of visible cases in the user's cache, where check_submission with its usual
/// plan looks for them, and takes those that are there.
void keep_runs_as_checks_do(Crew& crew, const std::vector<Exercise>& exercises);

}
