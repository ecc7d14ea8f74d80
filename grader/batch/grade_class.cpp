#include "batch/grade_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "batch/fingerprint.hpp"
#include "batch/share_out.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "report/json_files.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// What the workers of one class share.
class Work {
public:
    Work(const Toolchain& tools, const std::vector<Exercise>& exercises, const ClassOptions& options, const std::function<void(const SubmissionResult&)>& done)
        : tools_(tools), exercises_(exercises), options_(options), done_(done), ids_(submission_ids(options.submissions))
    {
        result_.submissions.resize(ids_.size());
    }

    ClassResult finish()
    {
        {
            Workshop first(tools_);
            result_.fingerprint = fingerprint(first, exercises_);
        }
        share_out(tools_, ids_.size(), options_.jobs, [this](Workshop& workshop, std::size_t index) { grade(workshop, index); });
        write_class_json(options_.out / "class.json", result_);
        html::ClassPageOptions page{{}, options_.instructor_edition};
        for (const Exercise& exercise : exercises_)
            if (const auto english = exercise.title.find("en"); english != exercise.title.end()) page.titles[exercise.id] = english->second;
        html::write_page(options_.out / "index.html", html::class_html(result_, page));
        return std::move(result_);
    }

private:
    void grade(Workshop& workshop, std::size_t index)
    {
        GradeOptions options;
        options.seeds = {options_.secret, options_.course, ids_[index], options_.attempt};
        options.explain = options_.explain;
        options.relative_to = options_.out / ids_[index];
        options.artefacts = options.relative_to / "pictures";
        html::Gallery gallery;
        options.gallery = &gallery;
        options.show_hidden = options_.instructor_edition;
        fs::remove_all(options.relative_to);
        fs::create_directories(options.relative_to);
        SubmissionResult submission = grade_submission(workshop, exercises_, options_.submissions / ids_[index], options);
        submission.id = ids_[index];
        write_report_json(options.relative_to / "report.json", submission, result_.fingerprint);
        write_pages(options.relative_to, submission, gallery);
        const std::lock_guard lock(mutex_);
        done_(submission);
        result_.submissions[index] = std::move(submission);
    }

    /// What the student may see, and for instructors who ask for it what they may not.
    void write_pages(const fs::path& folder, const SubmissionResult& submission, const html::Gallery& gallery) const
    {
        write_report_json(folder / "report.student.json", without_hidden_values(submission), result_.fingerprint);
        html::write_page(folder / "report.html", html::report_html(submission, result_.fingerprint, gallery));
        if (options_.instructor_edition)
            html::write_page(folder / "report.instructor.html",
                             html::report_html(submission, result_.fingerprint, gallery, {html::Edition::instructor, "../index.html"}));
    }

    const Toolchain& tools_;
    const std::vector<Exercise>& exercises_;
    const ClassOptions& options_;
    const std::function<void(const SubmissionResult&)>& done_;
    std::vector<std::string> ids_;
    ClassResult result_;
    std::mutex mutex_;
};

}

std::vector<std::string> submission_ids(const fs::path& folder)
{
    if (!fs::is_directory(folder)) throw std::runtime_error(fmt::format("{}: expected a folder with one folder a submission; there is none", folder.string()));
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!fs::is_directory(entry.symlink_status()) || name.starts_with('.')) continue;
        if (!is_submission_id(name))
            throw std::runtime_error(
                fmt::format("{}: a submission's folder is named with letters, digits, '.', '_' and '-' only; rename it", entry.path().string()));
        ids.push_back(name);
    }
    if (ids.empty()) throw std::runtime_error(fmt::format("{}: no submission in it; expected one folder each", folder.string()));
    std::sort(ids.begin(), ids.end());
    return ids;
}

SubmissionResult grade_submission(Workshop& workshop, const std::vector<Exercise>& exercises, const fs::path& folder, const GradeOptions& options)
{
    SubmissionResult submission;
    for (const Exercise& exercise : exercises) submission.units.push_back(grade_unit(workshop, exercise, collect(folder, exercise), options));
    add_up(submission);
    return submission;
}

ClassResult grade_class(const Toolchain& tools, const std::vector<Exercise>& exercises, const ClassOptions& options,
                        const std::function<void(const SubmissionResult&)>& done)
{
    return Work(tools, exercises, options, done).finish();
}

}
