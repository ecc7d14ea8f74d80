#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collect/class_folder.hpp"
#include "model/scorecard.hpp"
#include "store/kept_unit.hpp"
#include "store/reports_folder.hpp"
#include "worker/unit_key.hpp"

namespace umbral::grader {

/// What the submissions of one run have in common. Refers to what outlives it.
struct SubmissionPlan {
    const Toolchain& tools;
    const std::vector<Exercise>& exercises;  ///< of this run
    const std::vector<Exercise>& course;     ///< all, for the order and titles of units that earlier runs graded
    const ReportsFolder& out;
    const UnitKeys& keys;
    const KeyPlan& plan;
    const std::string& secret;
};

/// A submission's results, and what is to be known of how they came about.
struct Graded {
    SubmissionResult result;
    bool current = false;     ///< nothing is missing, nothing changed, and the reports are written
    std::size_t missing = 0;  ///< units of this run that have to be graded
    bool elsewhere = false;   ///< some result is of another version or machine
    std::vector<std::string>
        changed{};  ///< units with other points than before, as "raytracing/sphere: 10 of 10 before, 8 of 10 now"
};

/// A unit of a report that is being put together.
struct Part {
    KeptUnit unit;
    UnitSections sections;
};

/// The name of a submission's folder or archive, printable: what a mark calls its source.
[[nodiscard]] std::string source_of(const SubmissionFolder& submission);

/// Is what lies in `out` under a submission's id the work of another one in `all`? So it is where a roster has given
/// the id to another folder since. Never throws.
[[nodiscard]] bool holds_anothers_work(const SubmissionPlan& plan, const SubmissionFolder& submission,
                                       const std::vector<SubmissionFolder>& all);

/// What lies in `out` of a submission, and how much of it still holds. Reads only, and never throws: what cannot be
/// read is missing.
[[nodiscard]] Graded look_at(const SubmissionPlan& plan, const SubmissionFolder& submission);

/// The results of a submission that this run does not grade; nothing if its reports are not whole, or of another
/// grading. Never throws.
[[nodiscard]] std::optional<Graded> results_of_earlier_run(const SubmissionPlan& plan, const std::string& id);

/// Reads a submission's files. Throws as read_submission does.
[[nodiscard]] SubmittedFiles read_files(const SubmissionPlan& plan, const SubmissionFolder& submission);

/// Adds the units that this run does not ask for: they stay in the report as they are. Throws std::runtime_error if one
/// is damaged.
void add_units_of_earlier_runs(const SubmissionPlan& plan, const std::filesystem::path& folder,
                               std::vector<Part>& parts);

/// Units in the course's order; those that it does not know come last.
void put_in_order(const SubmissionPlan& plan, std::vector<Part>& parts);

/// The parts as a submission's result, with its sums.
[[nodiscard]] Graded result_of(const SubmissionPlan& plan, const std::string& id, const std::string& shown,
                               const std::vector<Part>& parts);

/// Digest of all that a submission's reports show.
[[nodiscard]] std::string reports_digest(const SubmissionPlan& plan, const SubmissionResult& result);

/// The files beside the reports that a result refers to, by paths relative to the folder of the reports.
[[nodiscard]] std::set<std::string> pictures_of(const UnitResult& unit);

/// May a kept result stand as it is: is it of the unit's points, and are its pictures all there?
[[nodiscard]] bool is_whole(const std::filesystem::path& folder, const Exercise& exercise, const UnitResult& unit);

/// Removes what is kept of all units of a submission, with their pictures; the reports stay. Throws
/// std::filesystem::filesystem_error.
void forget_results(const std::filesystem::path& folder);

}
