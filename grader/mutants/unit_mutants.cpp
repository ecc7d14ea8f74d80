#include "mutants/unit_mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "model/one_cpp_file.hpp"
#include "model/scratch.hpp"
#include "mutants/build_mutants.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {
namespace {

/// The unit's cases, those that killed most mutants first: as a rule the first one tried then kills the next.
class CaseOrder {
public:
    explicit CaseOrder(std::vector<std::string> cases) : cases_(std::move(cases)) {}

    std::vector<std::string> now()
    {
        const std::lock_guard lock(mutex_);
        return cases_;
    }

    void killed_by(const std::string& check)
    {
        const std::lock_guard lock(mutex_);
        for (const std::string& name : cases_)
            if (check.starts_with(name + "/") || check.ends_with(" in " + name)) ++kills_[name];
        std::ranges::stable_sort(cases_, std::ranges::greater(), [&](const std::string& name) { return kills_[name]; });
    }

private:
    std::mutex mutex_;
    std::vector<std::string> cases_;
    std::map<std::string, int> kills_;
};

/// Marks the survivors that the unit's file of equivalents gives a reason for, and keeps the entries that are about
/// none.
void compare_with_entries(const std::vector<Equivalent>& entries, const std::string& source, UnitMutants& unit)
{
    for (const Equivalent& entry : entries) {
        bool used = false;
        for (TriedMutant& one : unit.mutants)
            if (!one.trial.killed && is_about(entry, one.mutant, source)) {
                one.reason = entry.reason;
                used = true;
            }
        if (!used) unit.stale.push_back(entry);
    }
}

UnitMutants try_unit(Crew& crew, MutantFamily family, const std::filesystem::path& finder, const Exercise& exercise,
                     unsigned seed)
{
    const Toolchain& tools = crew.first().tools();
    const std::filesystem::path source = reference_files(tools.reference, exercise).begin()->second;
    UnitMutants unit{exercise.id, source.lexically_relative(tools.reference).string(), {}, 0};
    const std::vector<Equivalent> entries = equivalents_of(exercise.folder, family);
    const ScratchFolder work(tools.cache);
    const BuiltMutants built = build_mutants(tools, exercise, family, finder, read_text(source), work.path());
    unit.not_compiled = built.not_compiled;
    for (const Mutant& mutant : built.mutants) unit.mutants.push_back({mutant, {}});
    CaseOrder order(exercise.cases());
    // None chosen, it is the reference, and must lose nothing: else every mutant would count as killed.
    if (const Trial none = try_mutant(crew.first(), exercise, built.library, 0, order.now(), seed); none.killed)
        throw std::runtime_error(fmt::format("the reference itself loses points as it is built here: {}", none.by));
    crew.share_out(unit.mutants.size(), [&](Worker& worker, std::size_t index) {
        TriedMutant& one = unit.mutants[index];
        one.trial = try_mutant(worker, exercise, built.library, one.mutant.number, order.now(), seed);
        if (one.trial.killed) order.killed_by(one.trial.by);
    });
    compare_with_entries(entries, read_text(source), unit);
    return unit;
}

}

std::size_t UnitMutants::killed() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(mutants, [](const TriedMutant& one) { return one.trial.killed; }));
}

std::vector<const TriedMutant*> UnitMutants::survivors() const
{
    std::vector<const TriedMutant*> some;
    for (const TriedMutant& one : mutants)
        if (!one.trial.killed && one.reason.empty()) some.push_back(&one);
    return some;
}

bool UnitMutants::holds() const { return trouble.empty() && stale.empty() && survivors().empty(); }

void try_units(Crew& crew, MutantFamily family, const std::filesystem::path& finder,
               std::span<const Exercise> exercises, unsigned seed, const std::function<void(const UnitMutants&)>& done)
{
    for (const Exercise& exercise : exercises) {
        if (!is_one_cpp_file(exercise)) continue;
        try {
            done(try_unit(crew, family, finder, exercise, seed));
        } catch (const std::exception& error) {
            UnitMutants unit{exercise.id, "", {}, 0};
            unit.trouble = error.what();
            done(unit);
        }
    }
}

}
