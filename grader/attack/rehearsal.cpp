#include "attack/rehearsal.hpp"

#include <fmt/format.h>

#include "attack/findings.hpp"
#include "model/scratch.hpp"

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

/// A fresh folder that others may enter, as the user nobody must.
class OpenFolder {
public:
    explicit OpenFolder(const fs::path& parent) : folder_(parent)
    {
        fs::permissions(folder_.path(), fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
    }
    ~OpenFolder()
    {
        // What generators made unreadable could not be removed by an ordinary user.
        std::error_code ignored;
        for (fs::recursive_directory_iterator
                 at(folder_.path(), fs::directory_options::skip_permission_denied, ignored),
             end;
             !ignored && at != end; at.increment(ignored)) {
            std::error_code each;
            if (!at->is_symlink(each) && at->is_directory(each))
                fs::permissions(at->path(), fs::perms::owner_all, fs::perm_options::add, each);
        }
    }
    OpenFolder(const OpenFolder&) = delete;
    OpenFolder& operator=(const OpenFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return folder_.path(); }

private:
    ScratchFolder folder_;
};

class Rehearsing {
public:
    Rehearsing(const Target& target, const Setting& setting, const fs::path& scratch,
               const std::function<void(const std::string&)>& say)
        : target_(target), setting_(setting), scratch_(scratch), say_(say)
    {
    }

    Rehearsal all(std::span<const Attack> attacks)
    {
        units_ = units_of(attacks);
        const OpenFolder place(scratch_);
        before_ = grade_beside_good(target_, setting_, {}, units_, place.path());
        if (!before_.complete())
            throw std::runtime_error("good work alone cannot be graded: " + before_.how_it_ended());
        part(attacks, true);
        return std::move(result_);
    }

private:
    void part(std::span<const Attack> attacks, bool whole)
    {
        const OpenFolder place(scratch_);
        if (say_) say_(fmt::format("{}: {} attacks beside good work", setting_.name(), attacks.size()));
        const Graded graded = grade_beside_good(target_, setting_, attacks, units_, place.path());
        if (whole) {
            result_.run = graded.run;
            result_.cache_mib = graded.cache_kib / 1024;
            result_.reports_mib = graded.reports_kib / 1024;
        }
        if (!graded.complete() && attacks.size() > 1) {
            if (say_) say_(graded.how_it_ended());
            part(attacks.first(attacks.size() / 2), false);
            part(attacks.subspan(attacks.size() / 2), false);
            return;
        }
        for (const Attack& attack : attacks)
            result_.outcomes[attack.id()] = {outcome_of(attack, graded), findings(attack, graded)};
        if (!graded.complete()) return;
        for (const std::string& change : changes_of_good(before_, graded)) result_.changes_of_good.push_back(change);
    }

    const Target& target_;
    const Setting& setting_;
    const fs::path& scratch_;
    const std::function<void(const std::string&)>& say_;
    std::vector<std::string> units_;
    Graded before_;
    Rehearsal result_;
};

}

Rehearsal rehearse(const Target& target, const Setting& setting, std::span<const Attack> attacks,
                   const fs::path& scratch, const std::function<void(const std::string&)>& say)
{
    return Rehearsing(target, setting, scratch, say).all(attacks);
}

Outcome rehearse_alone(const Target& target, const Setting& setting, const Attack& attack, const fs::path& scratch)
{
    const OpenFolder place(scratch);
    const std::span<const Attack> one(&attack, 1);
    const Graded graded = grade_beside_good(target, setting, one, units_of(one), place.path());
    Outcome outcome{outcome_of(attack, graded), findings(attack, graded)};
    const auto hold = [&](double came, double most, const char* what) {
        if (came > most)
            outcome.findings.push_back(fmt::format("{} {:.0f}, at most {:.0f} were expected", what, came, most));
    };
    hold(graded.run.seconds, attack.bounds.seconds, "seconds it took with good work:");
    hold(graded.run.peak_mib, attack.bounds.grader_memory_mib, "MiB of the grader's memory:");
    hold((graded.cache_kib + graded.reports_kib) / 1024, attack.bounds.disk_mib, "MiB of disk:");
    outcome.came += fmt::format("; {:.1f} s, {:.0f} MiB of memory, {:.1f} MiB of disk", graded.run.seconds,
                                graded.run.peak_mib, (graded.cache_kib + graded.reports_kib) / 1024);
    return outcome;
}

}
