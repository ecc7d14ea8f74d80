#include "bench/explanations/explanations.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <umbral/core/random.hpp>

#include "bench/explanations/disturb.hpp"
#include "explain/explain_unit.hpp"
#include "explain/two_mistakes.hpp"
#include "judge/explain/confidence.hpp"
#include "judge/judges.hpp"
#include "judge/rules.hpp"
#include "model/digest.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_pairs = 3;

/// One unit with the inputs of one seed.
class Bench {
public:
    Bench(Worker& worker, const Exercise& exercise, unsigned seed)
        : worker_(worker), exercise_(exercise), seed_(seed), mistakes_(explaining_mistakes(worker, exercise))
    {
    }

    std::vector<ExplainedWork> all()
    {
        for (const KnownSolution& mistake : mistakes_) known(mistake);
        for (const Disturbance& disturbance : disturbances()) disturbed(disturbance);
        for (std::size_t i = 0; i < most_pairs && i + 1 < mistakes_.size(); ++i) both(mistakes_[i], mistakes_[i + 1]);
        return std::move(work_);
    }

private:
    using Answer = std::function<RunOutcome(const std::string& case_name, std::uint64_t seed)>;

    Random random_for(const std::string& what) const
    {
        return Random(case_seed("calibrate", what, "", exercise_.id, "", seed_));
    }

    CaseResults run(const Answer& answer)
    {
        worker_.let_go();
        const SeedPlan seeds{"bench explanations", "bench explanations", "bench explanations", seed_};
        CaseResults cases;
        for (const std::string& name : exercise_.cases()) {
            CaseResult one;
            one.seed = seeds.seed_of(exercise_, name);
            one.student = answer(name, one.seed);
            cases.emplace(name, std::move(one));
        }
        return cases;
    }

    /// Points as far as explanations ask for them: all of a check's, or not all; a relation's by its value alone.
    UnitResult judged(const CaseResults& cases)
    {
        UnitResult result;
        for (const Check& check : exercise_.checks) {
            const CaseResult& one = cases.at(check.case_name);
            const RunOutcome& run = worker_.trusted(exercise_, judged_against(check), check.case_name, one.seed);
            const auto [expected, margin, names] = expected_of(check, run);
            const Tensor* yours = observed(check, one.student);
            const bool right = one.cause().empty() && yours != nullptr && expected != nullptr &&
                               !shape_error(check, *yours, *expected) &&
                               fraction_right(check, *yours, *expected, margin) >= check.full;
            result.checks.push_back(blank_result(check));
            result.checks.back().score = right ? check.points : 0;
            result.score += result.checks.back().score;
            result.max_score += check.points;
        }
        return result;
    }

    RunOutcome run_of(const KnownSolution& mistake, const std::string& name, std::uint64_t seed)
    {
        return worker_.run_known(exercise_, mistake, name, seed);
    }

    /// The values that checks look at, each changed; the same change for the same seed.
    template <class Change>
    RunOutcome changed(RunOutcome run, const std::string& name, Change change, const std::set<std::string>& but = {})
    {
        std::set<std::string> values;
        for (const Check& check : exercise_.checks)
            if (check.case_name == name && judge_of(check).plain_values && !but.contains(check.value))
                values.insert(check.value);
        for (const std::string& value : values)
            if (const auto found = run.recording.tensors.find(value); found != run.recording.tensors.end())
                found->second = change(found->second);
        return run;
    }

    /// The values of a case that a check asks for so exactly that rounding would fail it: there other rounding is
    /// another error.
    std::set<std::string> exact_values(const std::string& name, std::uint64_t seed)
    {
        std::set<std::string> values;
        Random random = random_for(name);
        for (const Check& check : exercise_.checks) {
            if (check.case_name != name || !judge_of(check).plain_values) continue;
            const RunOutcome& run = worker_.trusted(exercise_, judged_against(check), name, seed);
            const auto [expected, margin, names] = expected_of(check, run);
            if (expected == nullptr ||
                fraction_right(check, rounded_otherwise(*expected, random), *expected, margin) < 1)
                values.insert(check.value);
        }
        return values;
    }

    void known(const KnownSolution& mistake)
    {
        const CaseResults cases =
            run([&](const std::string& name, std::uint64_t seed) { return run_of(mistake, name, seed); });
        const UnitResult result = judged(cases);
        if (result.score == result.max_score) return;
        const std::string own = mistake_title(mistake.name);
        note(WorkKind::mistake, mistake.name, explain_unit(worker_, exercise_, result, cases, mistakes_), own);

        Random random = random_for(own);
        const auto round = [&](const Tensor& tensor) { return rounded_otherwise(tensor, random); };
        const CaseResults rounded = run([&](const std::string& name, std::uint64_t seed) {
            return changed(run_of(mistake, name, seed), name, round, exact_values(name, seed));
        });
        note(WorkKind::rounded, mistake.name, explain_unit(worker_, exercise_, judged(rounded), rounded, mistakes_),
             own);

        std::vector<KnownSolution> others = mistakes_;
        std::erase_if(others, [&](const KnownSolution& other) { return other.name == mistake.name; });
        std::vector<Explanation> said = explain_unit(worker_, exercise_, result, cases, others);
        const bool twin = !said.empty() && is_mistake(said.front()) && equal(mistake, said.front().name, cases);
        note(WorkKind::left_out, mistake.name, std::move(said), twin ? "twin" : "");
    }

    void disturbed(const Disturbance& disturbance)
    {
        Random random = random_for(disturbance.name);
        bool changes = false;
        const CaseResults cases = run([&](const std::string& name, std::uint64_t seed) {
            return changed(worker_.trusted(exercise_, Answers::reference, name, seed), name, [&](const Tensor& right) {
                Tensor wrong = disturbance.apply(right, random);
                changes = changes || !(wrong == right);
                return wrong;
            });
        });
        const UnitResult result = judged(cases);
        if (changes && result.score < result.max_score)
            note(WorkKind::disturbed, disturbance.name, explain_unit(worker_, exercise_, result, cases, mistakes_), "");
    }

    // As if the code took one way for some inputs and another for the rest.
    void both(const KnownSolution& a, const KnownSolution& b)
    {
        std::size_t index = 0;
        const CaseResults cases = run(
            [&](const std::string& name, std::uint64_t seed) { return run_of(index++ % 2 == 0 ? a : b, name, seed); });
        const UnitResult result = judged(cases);
        if (result.score == result.max_score) return;
        std::vector<Explanation> said = explain_unit(worker_, exercise_, result, cases, mistakes_);
        const bool part =
            !said.empty() && (said.front().name == mistake_title(a.name) || said.front().name == mistake_title(b.name));
        note(WorkKind::two_mistakes, a.name + " + " + b.name, std::move(said),
             part ? "part" : two_mistakes_title(a.name, b.name));
    }

    bool equal(const KnownSolution& mistake, const std::string& other_title, const CaseResults& cases)
    {
        const auto other =
            std::ranges::find(mistakes_, other_title, [](const KnownSolution& one) { return mistake_title(one.name); });
        return std::ranges::all_of(exercise_.checks, [&](const Check& check) {
            const std::uint64_t seed = cases.at(check.case_name).seed;
            const RunOutcome a = run_of(mistake, check.case_name, seed);
            const RunOutcome b = run_of(*other, check.case_name, seed);
            const Tensor* one = tensor_of(a, check.value);
            const Tensor* two = tensor_of(b, check.value);
            return a.verdict == b.verdict && (one == nullptr || two == nullptr ? one == two : *one == *two);
        });
    }

    /// `truth`: the name that is right; "twin" or "part" for what these words say of the first explanation.
    void note(WorkKind kind, const std::string& subject, std::vector<Explanation> said, const std::string& truth)
    {
        Said outcome = Said::wrong;
        if (said.empty())
            outcome = Said::silent;
        else if (truth == "twin")
            outcome = Said::twin;
        else if (truth == "part")
            outcome = Said::part;
        else if (said.front().name == truth && !said.front().ambiguous)
            outcome = Said::right;
        else if (std::ranges::any_of(said, [&](const Explanation& one) { return one.ambiguous && one.name == truth; }))
            outcome = Said::right_among;
        else if (!is_mistake(said.front()) && said.front().fit >= 1)
            outcome = Said::true_statement;
        work_.push_back({exercise_.id, seed_, kind, subject, outcome, std::move(said)});
    }

    Worker& worker_;
    const Exercise& exercise_;
    unsigned seed_;
    std::vector<KnownSolution> mistakes_;
    std::vector<ExplainedWork> work_;
};

}

std::vector<ExplainedWork> explain_known_work(Worker& worker, const Exercise& exercise, unsigned seed)
{
    return Bench(worker, exercise, seed).all();
}

}
