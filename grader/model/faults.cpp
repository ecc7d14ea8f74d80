#include "model/faults.hpp"

#include <algorithm>
#include <array>

namespace umbral::grader {
namespace {

/// What the system says of a trouble, and what helps.
struct Known {
    std::string_view words;
    std::string_view remedy;
};

constexpr std::string_view space = "free some space there (or name another folder: --out, UMBRAL_CACHE)";
constexpr std::string_view memory = "close other programs or grade fewer submissions at a time (--jobs 1)";
constexpr std::string_view permission = "make that folder writable for you";

constexpr std::array known{
    Known{"No space left on device", space},
    Known{"Disk quota exceeded", space},
    Known{"File too large", "raise the limit of a file's size (ulimit -f unlimited)"},
    Known{"Cannot allocate memory", memory},
    Known{"bad_alloc", memory},
    Known{"Too many open files", "raise the limit of open files (ulimit -n 4096)"},
    Known{"Resource temporarily unavailable",
          "raise the limit of processes (ulimit -u) or grade fewer submissions at a time (--jobs 1)"},
    Known{"Read-only file system", permission},
    Known{"Permission denied", permission},
    Known{"belong here, but", "move that away"},
};

const Known* recognise(std::string_view cause)
{
    const auto found =
        std::ranges::find_if(known, [&](const Known& one) { return cause.find(one.words) != std::string_view::npos; });
    return found == known.end() ? nullptr : &*found;
}

class Collection {
public:
    void add(std::string_view cause, Fault::Place place, Millipoints points)
    {
        if (cause.starts_with(fault_preface)) cause.remove_prefix(fault_preface.size());
        const Known* const trouble = recognise(cause);
        // Which file a full disk hit first differs from unit to unit.
        const std::string_view key = trouble != nullptr ? trouble->words : cause;
        auto found = std::ranges::find(keys_, key);
        if (found == keys_.end()) {
            found = keys_.insert(keys_.end(), std::string(key));
            Fault& fault = all_.emplace_back();
            fault.cause = cause;
            fault.remedy = trouble != nullptr ? std::string(trouble->remedy)
                                              : "see what `umbral doctor` finds wrong with this machine";
            fault.remedy += " and run the same command again: only what is missing is graded";
        }
        Fault& fault = all_[static_cast<std::size_t>(found - keys_.begin())];
        fault.points += points;
        fault.places.push_back(std::move(place));
    }
    std::vector<Fault> take() { return std::move(all_); }

private:
    std::vector<std::string> keys_;
    std::vector<Fault> all_;
};

}

bool has_fault(const SubmissionResult& submission)
{
    return std::ranges::find(submission.units, Verdict::grader_fault, &UnitResult::verdict) != submission.units.end();
}

std::vector<Fault> faults(const ClassResult& result)
{
    Collection all;
    for (const SubmissionResult& submission : result.submissions)
        for (const UnitResult& unit : submission.units)
            if (unit.verdict == Verdict::grader_fault) all.add(unit.message, {submission.id, unit.id}, unit.unscored);
    for (const Unwritten& one : result.unwritten) all.add(one.cause, {one.submission, ""}, 0);
    return all.take();
}

}
