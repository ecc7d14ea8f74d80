#include "explain/two_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "explain/mistakes_ahead.hpp"
#include "judge/explain/confidence.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

/// What is looked at: all mistakes run on it.
constexpr std::size_t most_cells = 5'000;
constexpr std::size_t most_cases_covered = 12;

/// A failing check, and what each mistake recorded for it.
struct MistakenCheck {
    const FailingCheck* check = nullptr;
    std::vector<std::optional<Tensor>> by_mistake{};       ///< nothing if its run ended otherwise
    std::vector<std::size_t> wrong{};                      ///< cells in which the student deviates
    std::vector<std::uint64_t> clearly{};                  ///< a bit for each of them: by more than rounding
    std::vector<std::vector<std::uint64_t>> as_mistake{};  ///< for each mistake a bit for each of them: as it does
};

bool same_shape(const Tensor& a, const Tensor& b)
{
    return a.element == b.element && a.rows == b.rows && a.columns == b.columns && a.components == b.components &&
           a.present.empty() == b.present.empty();
}

/// How far two cells are apart; one that is absent is far from any other.
double distance(const TensorView& a, const TensorView& b, std::size_t cell)
{
    if (a.present(cell) != b.present(cell)) return INFINITY;
    double most = 0;
    for (std::size_t i = 0; i < a.components(); ++i) {
        const double apart = std::abs(a.cell(cell)[i] - b.cell(cell)[i]);
        most = std::isnan(apart) ? INFINITY : std::max(most, apart);
    }
    return most;
}

/// Near enough to be the same number, computed otherwise.
bool alike(const TensorView& a, const TensorView& b, std::size_t cell)
{
    constexpr double rounding = 1e-3;
    double size = 0;
    for (const double number : a.cell(cell)) size = std::max(size, std::abs(number));
    return distance(a, b, cell) <= rounding * size;
}

/// Takes down which of the student's wrong cells each mistake gives as well.
void compare(MistakenCheck& mistaken)
{
    const Tensor& student = *mistaken.check->student;
    const TensorView yours(student);
    const TensorView right(*mistaken.check->expected);
    const bool comparable = same_shape(student, *mistaken.check->expected);
    for (std::size_t cell = 0; comparable && cell < yours.cells(); ++cell)
        if (!(distance(yours, right, cell) == 0)) mistaken.wrong.push_back(cell);
    mistaken.clearly.resize((mistaken.wrong.size() + 63) / 64);
    for (std::size_t i = 0; i < mistaken.wrong.size(); ++i)
        if (!alike(yours, right, mistaken.wrong[i])) mistaken.clearly[i / 64] |= std::uint64_t{1} << (i % 64);
    for (const std::optional<Tensor>& its : mistaken.by_mistake) {
        std::vector<std::uint64_t>& bits = mistaken.as_mistake.emplace_back((mistaken.wrong.size() + 63) / 64);
        if (!its || !same_shape(student, *its)) continue;
        const TensorView view(*its);
        for (std::size_t i = 0; i < mistaken.wrong.size(); ++i)
            if (alike(yours, view, mistaken.wrong[i])) bits[i / 64] |= std::uint64_t{1} << (i % 64);
    }
}

/// Can the two together be the reason? A cheap look before all is weighed.
bool may_be(const MistakenCheck& mistaken, std::size_t a, std::size_t b)
{
    std::size_t covered = 0;
    for (std::size_t i = 0; i < mistaken.as_mistake[a].size(); ++i)
        covered += static_cast<std::size_t>(std::popcount(mistaken.as_mistake[a][i] | mistaken.as_mistake[b][i]));
    // Cells that are wrong by less than the check minds count here too.
    return 2 * covered >= mistaken.wrong.size();
}

/// Does one of the two give nearly all of the cells in which the student clearly deviates? A number between theirs is
/// neither's.
bool give_all(const MistakenCheck& mistaken, std::size_t a, std::size_t b)
{
    std::size_t all = 0;
    std::size_t given = 0;
    for (std::size_t i = 0; i < mistaken.clearly.size(); ++i) {
        const std::uint64_t by_them = mistaken.as_mistake[a][i] | mistaken.as_mistake[b][i];
        all += static_cast<std::size_t>(std::popcount(mistaken.clearly[i]));
        given += static_cast<std::size_t>(std::popcount(mistaken.clearly[i] & by_them));
    }
    return 20 * given >= 19 * all;
}

/// Cell by cell the one of two results that is nearer to the student's. Where shapes differ, the one of its shape.
Tensor nearer(const Tensor& student, const Tensor& a, const Tensor& b)
{
    if (!same_shape(student, a)) return b;
    if (!same_shape(student, b)) return a;
    const TensorView yours(student);
    const TensorView one(a);
    const TensorView other(b);
    Tensor result = a;
    const std::size_t size = a.components * size_of(a.element);
    for (std::size_t cell = 0; cell < yours.cells(); ++cell) {
        if (!(distance(yours, other, cell) < distance(yours, one, cell))) continue;
        std::memcpy(result.bytes.data() + cell * size, b.bytes.data() + cell * size, size);
        if (!result.present.empty()) result.present[cell] = b.present[cell];
    }
    return result;
}

/// Two mistakes, by their numbers.
using Pair = std::pair<std::size_t, std::size_t>;

std::vector<Pair> all_pairs(std::size_t mistakes)
{
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < mistakes; ++a)
        for (std::size_t b = a + 1; b < mistakes; ++b) pairs.emplace_back(a, b);
    return pairs;
}

/// What the mistakes do in all cases in which the student errs. Of `pairs` only those remain that may be the reason of
/// each: a mistake that is in none is not run any more, and there is nothing of it then.
std::vector<MistakenCheck> mistaken_checks(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups,
                                           std::span<const KnownSolution> mistakes, std::vector<Pair>& pairs)
{
    std::vector<MistakenCheck> all;
    std::size_t cases = 0;
    for (const CaseChecks& group : groups) {
        if (group.failing == 0 || !group.result->cause().empty() || group.cells > most_cells ||
            cases++ == most_cases_covered)
            continue;
        std::optional<MistakesAhead> ahead;
        for (const FailingCheck& check : group.checks) {
            if (check.student == nullptr || !judge_of(*check.check).plain_values || check.check->hard) continue;
            if (!well_formed(*check.student) || check.expected == nullptr || !well_formed(*check.expected)) continue;
            const auto is_in_any = [&pairs](std::size_t i) {
                return std::ranges::any_of(pairs,
                                           [i](const Pair& pair) { return pair.first == i || pair.second == i; });
            };
            if (!ahead) {
                std::vector<const KnownSolution*> to_run;
                for (std::size_t i = 0; i < mistakes.size(); ++i)
                    if (is_in_any(i)) to_run.push_back(&mistakes[i]);
                ahead.emplace(worker, exercise, group.name, group.result->seed, std::move(to_run));
            }
            MistakenCheck mistaken{&check};
            for (std::size_t i = 0; i < mistakes.size(); ++i) {
                const bool is_in_one = is_in_any(i);
                const RunOutcome* const run =
                    is_in_one ? &worker.run_known(exercise, mistakes[i], group.name, group.result->seed) : nullptr;
                const Tensor* tensor =
                    run != nullptr && run->verdict == Verdict::ok ? observed(*check.check, *run) : nullptr;
                mistaken.by_mistake.push_back(tensor == nullptr ? std::nullopt : std::optional(*tensor));
            }
            compare(mistaken);
            std::erase_if(pairs, [&](const Pair& pair) {
                return !may_be(mistaken, pair.first, pair.second) || !give_all(mistaken, pair.first, pair.second);
            });
            all.push_back(std::move(mistaken));
            if (pairs.empty()) return all;
        }
    }
    return all;
}

/// Does the student err in half of the cells or more in which `mistake` alone of the two errs? Nobody makes a mistake
/// in a few of its cells and is right in the others.
bool errs_where(const MistakenCheck& mistaken, std::size_t mistake, std::size_t other)
{
    const Tensor& student = *mistaken.check->student;
    const Tensor& expected = *mistaken.check->expected;
    const Tensor& its = *mistaken.by_mistake[mistake];
    const Tensor& others = *mistaken.by_mistake[other];
    if (!same_shape(student, expected) || !same_shape(student, its) || !same_shape(student, others)) return true;
    const TensorView yours(student);
    const TensorView right(expected);
    const TensorView wrong(its);
    const TensorView beside(others);
    std::size_t all = 0;
    std::size_t taken = 0;
    for (std::size_t cell = 0; cell < right.cells(); ++cell) {
        if (alike(wrong, right, cell) || !alike(beside, right, cell)) continue;
        ++all;
        if (alike(yours, wrong, cell)) ++taken;
    }
    return 2 * taken >= all;
}

bool speaks_for(const MistakenCheck& mistaken, std::size_t mistake)
{
    const std::optional<Tensor>& its = mistaken.by_mistake[mistake];
    return its && resemblance(*mistaken.check, *its).says == Says::for_it;
}

/// What all checks say of two mistakes made together; nothing if either is not needed, or anything speaks against it.
std::optional<Tally> weigh_pair(const std::vector<MistakenCheck>& all, std::size_t a, std::size_t b)
{
    Tally tally;
    bool needs_a = false;
    bool needs_b = false;
    for (const MistakenCheck& one : all) {
        if (!one.by_mistake[a] || !one.by_mistake[b]) return std::nullopt;
        // A list of another length than either's is nobody's.
        const Tensor& student = *one.check->student;
        if (!same_shape(student, *one.by_mistake[a]) && !same_shape(student, *one.by_mistake[b])) return std::nullopt;
        const Resemblance said = resemblance(*one.check, nearer(student, *one.by_mistake[a], *one.by_mistake[b]));
        if (said.says == Says::against_it) return std::nullopt;
        tally += said;
        if (said.says != Says::for_it) continue;
        if (!errs_where(one, a, b) || !errs_where(one, b, a)) return std::nullopt;
        needs_a = needs_a || !speaks_for(one, b);
        needs_b = needs_b || !speaks_for(one, a);
    }
    return needs_a && needs_b ? std::optional(tally) : std::nullopt;
}

}

std::string two_mistakes_title(const std::string& a, const std::string& b)
{
    return fmt::format("{}{} and {}", two_mistakes_begin, a, b);
}

std::vector<Explanation> by_two_mistakes(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups,
                                         std::span<const KnownSolution> mistakes)
{
    // What has no result to compare, two mistakes that have one do not explain.
    const auto has_none = [](const FailingCheck& one) { return one.fails && one.student == nullptr; };
    if (std::ranges::any_of(groups,
                            [&](const CaseChecks& group) { return std::ranges::any_of(group.checks, has_none); }))
        return {};
    std::vector<Pair> pairs = all_pairs(mistakes.size());
    const std::vector<MistakenCheck> all = mistaken_checks(worker, exercise, groups, mistakes, pairs);
    if (all.empty()) return {};
    std::vector<Explanation> found;
    for (const auto& [a, b] : pairs) {
        const std::optional<Tally> tally = weigh_pair(all, a, b);
        if (!tally || confidence(*tally) < thresholds::very_sure) continue;
        if (!found.empty()) return {};
        found.push_back({two_mistakes_title(mistakes[a].name, mistakes[b].name),
                         fmt::format("Two things at once. {} And: {}", mistakes[a].hint, mistakes[b].hint),
                         confidence(*tally), fit(*tally)});
    }
    return found;
}

}
