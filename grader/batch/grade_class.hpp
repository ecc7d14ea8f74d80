#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "batch/grade_unit.hpp"
#include "build/toolchain.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

struct ClassOptions {
    std::filesystem::path submissions;  ///< a folder with one folder a submission
    std::filesystem::path out;          ///< reports go here
    std::string secret;
    std::string course = "course";
    unsigned attempt = 0;
    unsigned jobs = 1;
    bool explain = true;
    bool instructor_edition = false;  ///< write report.instructor.html too, in which hidden checks show their values
};

/// The submissions of a class folder, sorted. Throws std::runtime_error if there is none, or if a folder's name is no id.
[[nodiscard]] std::vector<std::string> submission_ids(const std::filesystem::path& folder);

/// Grades every submission, `jobs` at a time, each worker with spawners of its own; writes `out/<id>/report.json`, what the
/// student may see of it (report.html, report.student.json) and pictures when a submission is done, and `out/class.json` and
/// `out/index.html` at the end. `done` is called (by one thread at a time) after each. The result's order is
/// that of the ids, whatever finishes first. Throws std::runtime_error if reports cannot be written.
[[nodiscard]] ClassResult grade_class(const Toolchain& tools, const std::vector<Exercise>& exercises, const ClassOptions& options,
                                      const std::function<void(const SubmissionResult&)>& done);

/// Grades one folder for all exercises.
[[nodiscard]] SubmissionResult grade_submission(Workshop& workshop, const std::vector<Exercise>& exercises, const std::filesystem::path& folder,
                                                const GradeOptions& options);

}
