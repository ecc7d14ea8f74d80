#include "mutants/try_repairs.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <optional>
#include <set>

#include "mutants/try_case.hpp"

namespace umbral::grader {
namespace {

using Clock = std::chrono::steady_clock;

/// So many changes that mend the first case are tried in all others.
constexpr std::size_t most_candidates = 60;
/// … and so many of them at a time.
constexpr std::size_t at_a_time = 12;
/// Of the wrong checks: what mends less has little to do with what is wrong.
constexpr double least_mended = 0.25;

using Names = std::set<std::string>;

/// A case with something wrong.
struct WrongCase {
    std::string name;
    const SeedPlan* seeds = nullptr;  ///< the inputs with which most is wrong
    Names shown;                      ///< checks that are wrong with these inputs
    Names checks;                     ///< … and with the inputs of any seed
    double seconds = 0;
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
        // Half of the time is for trying changes, as soon as there is something to try them on.
        const Clock::time_point half = Clock::now() + (end_ - Clock::now()) / 2;
        for (const std::string& name : exercise_.cases()) {
            if (!wrong_.empty() && Clock::now() >= half) break;
            if (WrongCase one = looked_at(name); !one.checks.empty()) wrong_.push_back(std::move(one));
        }
        for (const WrongCase& one : wrong_) std::ranges::copy(one.checks, std::back_inserter(result.wrong));
        std::ranges::stable_sort(wrong_, {}, &WrongCase::seconds);
        // Several things may be wrong, each in cases of its own.
        for (const WrongCase& one : wrong_) {
            std::vector<Repair> candidates = mending(one);
            result.tried = std::max(result.tried, tried_);
            confirm(candidates);
            if (!candidates.empty()) result.repairs = best_of(std::move(candidates));
            if (!result.repairs.empty() || is_over()) break;
        }
        result.out_of_time = result.repairs.empty() && is_over();
        return result;
    }

private:
    [[nodiscard]] bool is_over() const { return Clock::now() >= end_; }
    [[nodiscard]] Built chosen(unsigned number) const { return built_with(built_.library, number); }

    WrongCase looked_at(const std::string& name)
    {
        WrongCase one;
        one.name = name;
        for (const SeedPlan* seeds : all_seeds_) {
            const CaseTrial trial = try_case(crew_.first(), exercise_, chosen(0), name, *seeds);
            const Names wrong = wrong_in(exercise_, name, trial);
            one.checks.insert(wrong.begin(), wrong.end());
            one.seconds = trial.run.wall_seconds;
            if (wrong.size() > one.shown.size()) {
                one.shown = wrong;
                one.seeds = seeds;
            }
        }
        return one;
    }

    /// The changes with which checks of one case are right that were wrong with the same inputs, those that mend most
    /// first.
    std::vector<Repair> mending(const WrongCase& one)
    {
        std::vector<Repair> found;
        std::mutex mutex;
        tried_ = 0;
        crew_.share_out(built_.mutants.size(), [&](Worker& worker, std::size_t index) {
            if (is_over()) return;
            const Mutant& mutant = built_.mutants[index];
            const CaseTrial trial = try_case(worker, exercise_, chosen(mutant.number), one.name, *one.seeds);
            const Names still = wrong_in(exercise_, one.name, trial);
            std::vector<std::string> mends;
            std::ranges::set_difference(one.shown, still, std::back_inserter(mends));
            const std::lock_guard lock(mutex);
            ++tried_;
            if (!mends.empty() && std::ranges::includes(one.shown, still)) found.push_back({mutant, std::move(mends)});
        });
        std::ranges::sort(found, {},
                          [](const Repair& each) { return std::pair(-std::ssize(each.mends), each.change.number); });
        if (found.size() > most_candidates) found.resize(most_candidates);
        return found;
    }

    /// Keeps what breaks nothing in any case, and mends the same on other inputs; adds what it mends elsewhere. Those
    /// that mend most come first, some at a time: once one holds, no others are looked at.
    void confirm(std::vector<Repair>& candidates)
    {
        std::vector<Repair> confirmed;
        for (std::size_t first = 0; first < candidates.size() && confirmed.empty(); first += at_a_time) {
            const std::size_t count = std::min(at_a_time, candidates.size() - first);
            std::vector<char> holds(count, 0);
            crew_.share_out(count, [&](Worker& worker, std::size_t index) {
                if (is_over()) return;
                Repair& candidate = candidates[first + index];
                if (std::optional<std::vector<std::string>> mends = mended(worker, candidate)) {
                    candidate.mends = std::move(*mends);
                    holds[index] = 1;
                }
            });
            for (std::size_t i = 0; i < count; ++i)
                if (holds[i] != 0) confirmed.push_back(std::move(candidates[first + i]));
        }
        candidates = std::move(confirmed);
    }

    std::optional<std::vector<std::string>> mended(Worker& worker, const Repair& repair)
    {
        std::vector<std::string> mends;
        for (const std::string& name : exercise_.cases()) {
            const auto known = std::ranges::find(wrong_, name, &WrongCase::name);
            const Names before = known == wrong_.end() ? Names() : known->checks;
            Names still;
            for (const SeedPlan* seeds : all_seeds_) {
                const CaseTrial trial = try_case(worker, exercise_, chosen(repair.change.number), name, *seeds);
                still.merge(wrong_in(exercise_, name, trial));
            }
            if (!std::ranges::includes(before, still)) return std::nullopt;
            std::ranges::set_difference(before, still, std::back_inserter(mends));
        }
        if (mends.empty()) return std::nullopt;
        return mends;
    }

    /// Those that mend most; none if that is little.
    std::vector<Repair> best_of(std::vector<Repair> repairs) const
    {
        const std::size_t most =
            std::ranges::max(repairs, {}, [](const Repair& one) { return one.mends.size(); }).mends.size();
        std::size_t wrong = 0;
        for (const WrongCase& one : wrong_) wrong += one.checks.size();
        if (static_cast<double>(most) < least_mended * static_cast<double>(wrong)) return {};
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
    const std::array<const SeedPlan*, 2> all_seeds_{&seeds_, &other_seeds_};
    std::vector<WrongCase> wrong_;  ///< the quickest first
    std::size_t tried_ = 0;
};

}

RepairSearch try_repairs(Crew& crew, const Exercise& exercise, const BuiltMutants& built, const RepairPlan& plan)
{
    return Search(crew, exercise, built, plan).run();
}

}
