#include "batch/two_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "judge/explain/confidence.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

/// What is looked at: all mistakes run on it.
constexpr std::size_t most_cells = 5'000;
constexpr std::size_t most_cases = 12;

/// A failing check, and what each mistake recorded for it: null if its run ended otherwise.
struct MistakenCheck {
    const FailingCheck* check = nullptr;
    std::vector<std::optional<Tensor>> by_mistake;
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

std::vector<MistakenCheck> mistaken_checks(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups,
                                           std::span<const KnownSolution> mistakes)
{
    std::vector<MistakenCheck> all;
    std::size_t cases = 0;
    for (const CaseChecks& group : groups) {
        if (group.failing == 0 || !group.result->trouble().empty() || group.cells > most_cells || cases++ == most_cases)
            continue;
        for (const FailingCheck& check : group.checks) {
            if (check.student == nullptr || !judge_of(*check.check).plain_values || check.check->hard) continue;
            MistakenCheck mistaken{&check, {}};
            for (const KnownSolution& mistake : mistakes) {
                const RunOutcome& run =
                    worker.run_mistake(exercise, mistake.name, mistake.sources, group.name, group.result->seed);
                const Tensor* tensor = run.verdict == Verdict::ok ? observed(*check.check, run) : nullptr;
                mistaken.by_mistake.push_back(tensor == nullptr ? std::nullopt : std::optional(*tensor));
            }
            all.push_back(std::move(mistaken));
        }
    }
    return all;
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
        const Resemblance said =
            resemblance(*one.check, nearer(*one.check->student, *one.by_mistake[a], *one.by_mistake[b]));
        if (said.says == Says::against_it) return std::nullopt;
        tally += said;
        if (said.says != Says::for_it) continue;
        needs_a = needs_a || !speaks_for(one, b);
        needs_b = needs_b || !speaks_for(one, a);
    }
    return needs_a && needs_b ? std::optional(tally) : std::nullopt;
}

}

std::string two_mistakes_title(const std::string& a, const std::string& b)
{
    return fmt::format("mistakes: {} and {}", a, b);
}

std::vector<Explanation> by_two_mistakes(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups,
                                         std::span<const KnownSolution> mistakes)
{
    const std::vector<MistakenCheck> all = mistaken_checks(worker, exercise, groups, mistakes);
    if (all.empty()) return {};
    std::vector<Explanation> found;
    for (std::size_t a = 0; a < mistakes.size(); ++a)
        for (std::size_t b = a + 1; b < mistakes.size(); ++b) {
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
