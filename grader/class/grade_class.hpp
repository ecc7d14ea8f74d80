#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "class/class_progress.hpp"
#include "collect/class_folder.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader {

struct ClassOptions {
    std::filesystem::path submissions;  ///< a folder with one folder or archive a submission
    std::filesystem::path roster;       ///< see class_folder(); empty for none
    std::filesystem::path out;          ///< reports go here
    std::vector<std::string> only;      ///< ids to grade; empty: all
    std::vector<Exercise>
        course_units;  ///< all there are, for order and titles of units that earlier runs graded; empty: those graded
    std::optional<Fingerprint> fingerprint;  ///< of this machine, if it is known already; else the spawners are asked
    std::string secret;
    std::string course = "course";
    unsigned attempt = 0;
    std::size_t jobs = 1;
    bool explain = true;
    bool instructor_edition = false;  ///< write report.instructor.html too, in which hidden checks show their values
    bool fresh = false;               ///< ask again for what was kept
    std::vector<LeftOut> left_out{};  ///< for the result to tell of
};

/// What one run did.
struct ClassGrading {
    ClassResult result;          ///< as class.json has it, with submissions of earlier runs
    std::size_t units_kept = 0;  ///< of the submissions asked for
    std::size_t units_graded = 0;
    std::size_t earlier = 0;  ///< submissions of earlier runs that were not asked for
    std::vector<std::string>
        changed;  ///< "ana, raytracing/sphere: 10 of 10 before, 8 of 10 now": grades that are others than before
    std::vector<Ignored> ignored;  ///< in the class's folder
    bool written = true;           ///< class.json and all reports could be written
};

/// Grades every submission, `jobs` at a time, each worker with spawners of its own. Of each unit the result is kept
/// below `out/ID` as soon as it is there, and is not asked for again while nothing changes that it depends on
/// (UnitKeys): whenever the process is killed, the same call goes on where it was. Reports (report.json, report.html
/// and what the student may see of them) are written when a submission is done, `out/class.json` and `out/index.html`
/// every few seconds and at the end; they list the submissions of earlier runs too.
///
/// Units with a fault of the grader's are graded once more at the end, alone. `progress` is called by one thread at a
/// time. The result's order is that of the ids, whatever finishes first.
///
/// Nothing that a submission is or does throws. Throws RefusedFolder if `out` cannot be used or holds results of
/// another grading, or `only` names nobody; std::runtime_error if there is no submission, or the class's folder or the
/// roster cannot be read.
[[nodiscard]] ClassGrading grade_class(const Toolchain& tools, const std::vector<Exercise>& exercises,
                                       const ClassOptions& options,
                                       const std::function<void(const ClassProgress&)>& progress);

}
