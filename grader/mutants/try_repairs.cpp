#include "mutants/try_repairs.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "mutants/try_case.hpp"

namespace umbral::grader {
namespace {

using Clock = std::chrono::steady_clock;

/// So many changes that mend the first case are tried in all others.
constexpr std::size_t most_candidates = 60;

using Names = std::set<std::string>;

/// What is wrong in each of a unit's cases.
struct Wrong {
    std::map<std::string, Names> checks;  ///< by their case
    std::map<std::string, double> seconds;

    [[nodiscard]] std::vector<std::string> all() const
    {
        std::vector<std::string> names;
        for (const auto& [name, wrong] : checks) names.insert(names.end(), wrong.begin(), wrong.end());
        return names;
    }
    /// Those with something wrong, by the time that they take.
    [[nodiscard]] std::vector<std::string> cases() const
    {
        std::vector<std::string> names;
        for (const auto& [name, wrong] : checks)
            if (!wrong.empty()) names.push_back(name);
        std::ranges::stable_sort(names, {}, [&](const std::string& name) { return seconds.at(name); });
        return names;
    }
};

/// The checks of a case that are not right: all of them if its run did not end well.
Names wrong_in(const Exercise& exercise, const std::string& name, const CaseTrial& trial)
{
    Names wrong;
    if (trial.run.verdict != Verdict::ok) {
        for (const Check& check : exercise.checks)
            if (check.case_name == name) wrong.insert(check.name);
        return wrong;
    }
    for (const CheckResult& check : trial.checks)
        if (!CaseTrial::is_right(check)) wrong.insert(check.name);
    return wrong;
}

class Search {
public:
    Search(Crew& crew, const Exercise& exercise, const BuiltMutants& built, const RepairPlan& plan)
        : crew_(crew),
          exercise_(exercise),
          built_(built),
          end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(plan.seconds)))
    {
        seeds_.attempt = plan.attempt;
        other_seeds_.attempt = plan.attempt + 1;
    }

    RepairSearch run()
    {
        RepairSearch result;
        for (const std::string& name : exercise_.cases())
            for (const SeedPlan* seeds : {&seeds_, &other_seeds_}) {
                const CaseTrial trial = try_case(crew_.first(), exercise_, chosen(0), name, *seeds);
                wrong_.checks[name].merge(wrong_in(exercise_, name, trial));
                wrong_.seconds[name] = trial.run.wall_seconds;
            }
        result.wrong = wrong_.all();
        // Several things may be wrong, each in cases of its own.
        for (const std::string& name : wrong_.cases()) {
            std::vector<Repair> candidates = mending(name);
            result.tried = std::max(result.tried, tried_);
            confirm(candidates);
            if (!candidates.empty()) result.repairs = best_of(std::move(candidates));
            if (!result.repairs.empty() || is_over()) break;
        }
        return result;
    }

private:
    [[nodiscard]] bool is_over() const { return Clock::now() >= end_; }
    [[nodiscard]] Built chosen(unsigned number) const { return built_with(built_.library, number); }

    /// The changes with which checks of one case are right that were wrong, those that mend most first.
    std::vector<Repair> mending(const std::string& name)
    {
        std::vector<Repair> found;
        std::mutex mutex;
        tried_ = 0;
        crew_.share_out(built_.mutants.size(), [&](Worker& worker, std::size_t index) {
            if (is_over()) return;
            const Mutant& mutant = built_.mutants[index];
            const CaseTrial trial = try_case(worker, exercise_, chosen(mutant.number), name, seeds_);
            const Names still = wrong_in(exercise_, name, trial);
            const Names& before = wrong_.checks.at(name);
            std::vector<std::string> mends;
            std::ranges::set_difference(before, still, std::back_inserter(mends));
            const std::lock_guard lock(mutex);
            ++tried_;
            if (!mends.empty() && std::ranges::includes(before, still)) found.push_back({mutant, std::move(mends)});
        });
        std::ranges::sort(found, {},
                          [](const Repair& one) { return std::pair(-std::ssize(one.mends), one.change.number); });
        if (found.size() > most_candidates) found.resize(most_candidates);
        return found;
    }

    /// Keeps what breaks nothing in any case, and mends the same on other inputs; adds what it mends elsewhere.
    void confirm(std::vector<Repair>& candidates)
    {
        std::vector<char> holds(candidates.size(), 0);
        crew_.share_out(candidates.size(), [&](Worker& worker, std::size_t index) {
            if (std::optional<std::vector<std::string>> mends = mended(worker, candidates[index])) {
                candidates[index].mends = std::move(*mends);
                holds[index] = 1;
            }
        });
        std::size_t index = 0;
        std::erase_if(candidates, [&](const Repair&) { return holds[index++] == 0; });
    }

    std::optional<std::vector<std::string>> mended(Worker& worker, const Repair& repair)
    {
        std::vector<std::string> mends;
        for (const std::string& name : exercise_.cases()) {
            const Names& before = wrong_.checks.at(name);
            Names still;
            for (const SeedPlan* seeds : {&seeds_, &other_seeds_}) {
                const Names wrong =
                    wrong_in(exercise_, name, try_case(worker, exercise_, chosen(repair.change.number), name, *seeds));
                still.insert(wrong.begin(), wrong.end());
            }
            if (!std::ranges::includes(before, still)) return std::nullopt;
            std::ranges::set_difference(before, still, std::back_inserter(mends));
        }
        if (mends.empty()) return std::nullopt;
        return mends;
    }

    static std::vector<Repair> best_of(std::vector<Repair> repairs)
    {
        const std::size_t most =
            std::ranges::max(repairs, {}, [](const Repair& one) { return one.mends.size(); }).mends.size();
        std::erase_if(repairs, [&](const Repair& one) { return one.mends.size() < most; });
        std::ranges::stable_sort(repairs, {}, [](const Repair& one) { return one.change.line; });
        const auto same = std::ranges::unique(repairs, {}, [](const Repair& one) { return one.change.line; });
        repairs.erase(same.begin(), same.end());
        return repairs;
    }

    Crew& crew_;
    const Exercise& exercise_;
    const BuiltMutants& built_;
    Clock::time_point end_;
    SeedPlan seeds_;
    SeedPlan other_seeds_;
    Wrong wrong_;
    std::size_t tried_ = 0;
};

}

RepairSearch try_repairs(Crew& crew, const Exercise& exercise, const BuiltMutants& built, const RepairPlan& plan)
{
    return Search(crew, exercise, built, plan).run();
}

}
