#include "class/grade_class.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>

#include "class/class_book.hpp"
#include "class/grade_submission.hpp"
#include "model/caps.hpp"
#include "model/digest.hpp"
#include "model/faults.hpp"
#include "model/recording.hpp"
#include "report/formats.hpp"
#include "store/distinct_folders.hpp"
#include "store/refused_folder.hpp"
#include "store/report_folder.hpp"
#include "text/printable.hpp"
#include "worker/crew.hpp"
#include "worker/fingerprint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// How often a cause of faults is met again by units that are graded alone, before the rest of its units is left for
/// another day.
constexpr int most_retries = 2;

ClassFolder find_class(const ClassOptions& options)
{
    try {
        expect_distinct(options.submissions, options.out);
        ClassFolder found = class_folder(options.submissions, options.roster, ids_by_source(options.out));
        if (found.submissions.empty())
            throw std::runtime_error(fmt::format("{}: no submission in it; expected one folder or archive each",
                                                 options.submissions.string()));
        return found;
    } catch (const RefusedFolder&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw RefusedFolder(error.what());
    }
}

std::vector<SubmissionFolder> chosen(const ClassFolder& folder, const ClassOptions& options)
{
    if (options.only.empty()) return folder.submissions;
    std::vector<SubmissionFolder> result;
    for (const SubmissionFolder& one : folder.submissions)
        if (std::ranges::find(options.only, one.id) != options.only.end()) result.push_back(one);
    for (const std::string& id : options.only) {
        if (std::ranges::find(result, id, &SubmissionFolder::id) != result.end()) continue;
        std::vector<std::string> known;
        for (const SubmissionFolder& one : folder.submissions) known.push_back(one.id);
        throw RefusedFolder(fmt::format("--only {}: there is no such submission in {}; there are {}", one_line(id),
                                        options.submissions.string(), listed(known)));
    }
    return result;
}

std::string difference(const Grading& there, const Grading& now)
{
    std::vector<std::string> words;
    if (there.course != now.course)
        words.push_back(fmt::format("course '{}' instead of '{}'", there.course, now.course));
    if (there.attempt != now.attempt)
        words.push_back(fmt::format("attempt {} instead of {}", there.attempt, now.attempt));
    if (there.secret != now.secret) words.emplace_back("another secret");
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Makes sure that a table never mixes results of different gradings, whose hidden inputs differ.
void agree_on_grading(ReportsFolder& out, const Grading& grading, const std::vector<SubmissionFolder>& submissions,
                      bool fresh)
{
    if (out.grading() == grading) return;
    const std::string what = fmt::format("--out {}: its results were graded with other hidden inputs: {}",
                                         out.path().string(), difference(out.grading(), grading));
    if (!fresh) throw RefusedFolder(what + "; name another folder, or add --fresh to grade all of them again");
    std::vector<std::string> others;
    for (const std::string& id : out.submissions())
        if (std::ranges::find(submissions, id, &SubmissionFolder::id) == submissions.end()) others.push_back(id);
    if (!others.empty())
        throw RefusedFolder(fmt::format("{}; not all of them would be graded again ({} would not): name another folder",
                                        what, listed(others)));
    out.set_grading(grading);
}

/// From now on nothing of a submission counts as kept; its reports stay until there are others.
void forget(const ReportsFolder& out, const std::string& id)
{
    const fs::path folder = out.folder_of(id);
    std::optional<Mark> mark = fs::exists(fs::symlink_status(folder)) ? read_mark(folder) : std::nullopt;
    if (!mark || mark->submission != id) return;
    mark->reports.clear();
    set_mark(folder, *mark);
    forget_results(folder);
}

class ClassWork {
public:
    ClassWork(const Toolchain& tools, const std::vector<Exercise>& exercises, const ClassOptions& options,
              const std::function<void(const ClassProgress&)>& progress)
        : tools_(tools),
          exercises_(exercises),
          options_(options),
          progress_(progress),
          class_(find_class(options)),
          submissions_(chosen(class_, options)),
          key_plan_{options.fingerprint ? *options.fingerprint : asked_fingerprint(),
                    {printable(options.course, 4096), options.attempt, secret_fingerprint(options.secret)},
                    options.explain,
                    options.instructor_edition},
          out_(options.out, key_plan_.grading),
          keys_(tools, exercises, key_plan_),
          plan_{tools,     exercises,     options.course_units.empty() ? exercises : options.course_units, out_, keys_,
                key_plan_, options.secret},
          book_(plan_, options.left_out)
    {
    }

    ClassGrading run()
    {
        agree_on_grading(out_, key_plan_.grading, submissions_, options_.fresh);
        for (const auto& file : class_files()) out_.tidy(file.name);
        ClassGrading done;
        look(done);
        {
            const std::lock_guard lock(mutex_);
            book_.begin();
            tell("");
        }
        // Where there are fewer submissions than workers, several share the units of each.
        const std::size_t each = options_.jobs / std::max<std::size_t>(todo_.size(), 1);
        Crew(tools_, options_.jobs).share_out(todo_.size(), [&](Worker& worker, std::size_t index) {
            Crew crew = each > 1 ? Crew(tools_, each) : Crew(worker);
            grade(crew, todo_[index]);
        });
        retry_faults();
        done.written = book_.close();
        done.result = book_.result();
        done.changed = book_.changed();
        done.units_graded = now_.units_graded;
        done.ignored = class_.ignored;
        return done;
    }

private:
    [[nodiscard]] Fingerprint asked_fingerprint() const
    {
        Worker first(tools_);
        return fingerprint(first, exercises_);
    }

    /// What holds of earlier runs, and what has to be graded.
    void look(ClassGrading& done)
    {
        for (const std::string& id : out_.submissions()) {
            if (std::ranges::find(submissions_, id, &SubmissionFolder::id) != submissions_.end()) continue;
            ++done.earlier;
            if (const auto graded = results_of_earlier_run(plan_, id))
                book_.enter(*graded);
            else
                book_.await(id);
        }
        now_.submissions = submissions_.size();
        for (std::size_t i = 0; i < submissions_.size(); ++i) {
            if (options_.fresh || holds_anothers_work(plan_, submissions_[i], class_.submissions))
                forget(out_, submissions_[i].id);
            const Graded seen = look_at(plan_, submissions_[i]);
            done.units_kept += exercises_.size() - seen.missing;
            now_.units_to_grade += seen.missing;
            if (seen.current) {
                book_.enter(seen);
                ++now_.submissions_done;
                continue;
            }
            if (const auto before = results_of_earlier_run(plan_, submissions_[i].id)) book_.enter(*before);
            book_.await(submissions_[i].id);
            todo_.push_back(i);
        }
    }

    void grade(Crew& crew, std::size_t index)
    {
        if (book_.is_shut()) return;
        const SubmissionFolder& submission = submissions_[index];
        try {
            const Graded graded = grade_submission(crew, plan_, submission, [this] {
                const std::lock_guard lock(mutex_);
                ++now_.units_graded;
                tell("");
            });
            const std::lock_guard lock(mutex_);
            book_.enter(graded);
            faulty_.erase(index);
            if (has_fault(graded.result)) faulty_.insert(index);
        } catch (const RefusedFolder& refused) {
            const std::lock_guard lock(mutex_);
            book_.enter_trouble(submission.id, refused.what(), false);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            book_.enter_trouble(submission.id, error.what(), true);
        }
        const std::lock_guard lock(mutex_);
        if (!retrying_) ++now_.submissions_done;
        tell(submission.id);
        book_.publish_if_due();
    }

    /// Once more, with nothing beside them: what the machine could not do for many it may do for one.
    void retry_faults()
    {
        retrying_ = true;
        std::map<std::string, int> again;
        for (const std::size_t index : std::set<std::size_t>(faulty_)) {
            const auto causes = [&] { return book_.causes_of(submissions_[index].id); };
            if (book_.is_shut() ||
                std::ranges::all_of(causes(), [&](const std::string& cause) { return again[cause] >= most_retries; }))
                continue;
            now_.units_to_grade += causes().size();
            Crew alone(tools_, 1);
            grade(alone, index);
            for (const std::string& cause : causes()) ++again[cause];
        }
    }

    void tell(const std::string& finished)
    {
        now_.finished = finished;
        now_.again = retrying_;
        now_.seconds = book_.seconds();
        progress_(now_);
    }

    const Toolchain& tools_;
    const std::vector<Exercise>& exercises_;
    const ClassOptions& options_;
    const std::function<void(const ClassProgress&)>& progress_;
    ClassFolder class_;
    std::vector<SubmissionFolder> submissions_;
    KeyPlan key_plan_;
    ReportsFolder out_;
    UnitKeys keys_;
    SubmissionPlan plan_;
    std::vector<std::size_t> todo_;  ///< places in submissions_
    bool retrying_ = false;

    std::mutex mutex_;  ///< guards what follows
    ClassBook book_;
    ClassProgress now_;
    std::set<std::size_t> faulty_;
};

}

ClassGrading grade_class(const Toolchain& tools, const std::vector<Exercise>& exercises, const ClassOptions& options,
                         const std::function<void(const ClassProgress&)>& progress)
{
    return ClassWork(tools, exercises, options, progress).run();
}

}
