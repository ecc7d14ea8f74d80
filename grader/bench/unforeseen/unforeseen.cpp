#include "bench/unforeseen/unforeseen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <umbral/core/random.hpp>

#include "explain/common_answer.hpp"
#include "explain/common_condition.hpp"
#include "explain/other_questions.hpp"
#include "explain/question_words.hpp"
#include "explain/right_with.hpp"
#include "explain/wrong_dependence.hpp"
#include "model/digest.hpp"
#include "model/scratch.hpp"
#include "mutants/build_mutants.hpp"
#include "mutants/schemata.hpp"
#include "report/reasons.hpp"
#include "unit/grade_unit.hpp"
#include "worker/interface_text.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {
namespace {

using Truth = ToldSentence::Truth;

/// Seeds of inputs, none of which `umbral validate` uses, on whose the units were made.
constexpr unsigned seen_inputs = 1'000;
constexpr std::array other_inputs{1'001U, 1'002U};

/// How many changes are tried for each that is wanted: some lose no points.
constexpr unsigned most_tries = 4;

GradeOptions options_for(unsigned inputs)
{
    GradeOptions options;
    options.seeds = {"bench unforeseen", "bench unforeseen", "bench unforeseen", inputs, "bench unforeseen"};
    return options;
}

/// Tries what is said of one unit's bugs.
class Trial {
public:
    Trial(Worker& worker, const Exercise& exercise, std::filesystem::path library)
        : worker_(worker), exercise_(exercise), headers_(interface_text(worker, exercise))
    {
        built_.verdict = Verdict::ok;
        built_.library = std::move(library);
    }

    /// Of a library's mutants `chosen`; nothing if they lose no points. `files` are as this mutant has them, or none.
    std::optional<UnforeseenBug> explain(unsigned chosen, Sources files = {}, std::size_t line = 0)
    {
        built_.mutant = chosen;
        built_.files = std::move(files);
        const UnitResult result = grade_built(worker_, exercise_, built_, options_for(seen_inputs));
        if (result.verdict == Verdict::grader_fault) throw std::runtime_error(result.message);
        if (result.score == result.max_score) return std::nullopt;
        UnforeseenBug bug{exercise_.id, "", false};
        bug.stopped = std::ranges::all_of(result.checks, [&](const CheckResult& check) {
            return check.score == check.max_score || !check.first_difference;
        });
        bug.has_question = std::ranges::any_of(result.checks, [](const CheckResult& check) {
            return check.first_difference && !check.first_difference->question.empty();
        });
        for (const CheckResult& check : result.checks)
            if (check.code_place) bug.said.push_back(tried_place(check, line));
        if (!main_reasons(result).empty()) bug.said.push_back(tried_reason(result));
        for (std::size_t i = 0; i < result.checks.size(); ++i) {
            if (!result.checks[i].depends.empty()) try_depends(exercise_.checks[i], result.checks[i].depends, bug);
            if (!result.checks[i].common.empty() || !result.checks[i].practice.empty())
                try_common(exercise_.checks[i], bug);
        }
        return bug;
    }

private:
    /// Is the place that is told the changed one?
    static ToldSentence tried_place(const CheckResult& check, std::size_t changed)
    {
        constexpr int near = 2;
        const CodePlace& place = *check.code_place;
        const bool is_near = std::abs(place.line - static_cast<int>(changed)) <= near;
        return {ToldSentence::Kind::place, check.name,
                fmt::format("{}:{}, {}: {}", place.file, place.line, place.sentence, place.text),
                is_near ? Truth::holds : Truth::untried};
    }

    /// Is one of the reasons, if several fit alike, given with other inputs too?
    ToldSentence tried_reason(const UnitResult& result)
    {
        std::set<std::string> names;
        for (const Explanation& one : main_reasons(result)) names.insert(one.name);
        ToldSentence sentence{ToldSentence::Kind::reason, "", fmt::format("{}", fmt::join(names, " or "))};
        for (const unsigned inputs : other_inputs) {
            GradeOptions options = options_for(inputs);
            options.questions = false;
            const UnitResult again = grade_built(worker_, exercise_, built_, options);
            if (again.score == again.max_score) continue;
            const bool said = std::ranges::any_of(again.explanations,
                                                  [&](const Explanation& one) { return names.contains(one.name); });
            note(sentence, said);
        }
        return sentence;
    }

    /// Calls `use` with the check, its case run with these inputs, and the time that it may take.
    template <class Use>
    auto with_asked(const Check& check, unsigned inputs, const Use& use)
    {
        CaseResult one;
        one.hidden = is_hidden_case(exercise_, check.case_name);
        one.seed = options_for(inputs).seeds.seed_of(exercise_, check.case_name);
        one.student = worker_.run(exercise_, built_, check.case_name, one.seed);
        CaseRuns runs(worker_, exercise_, built_, check.case_name, one);
        const AskedCheck asked{exercise_, check, runs, one, worker_.questions(exercise_, check.case_name, one.seed),
                               headers_};
        SpareTime time;
        time.allow(exercise_.limits.wall_seconds);
        return use(asked, time);
    }

    /// Takes down whether a sentence holds with other inputs too.
    static void note(ToldSentence& sentence, bool holds)
    {
        if (!holds) sentence.truth = Truth::fails;
        if (holds && sentence.truth == Truth::untried) sentence.truth = Truth::holds;
    }

    /// Do wrong answers to other inputs depend on the same?
    ToldSentence tried_dependence(const Check& check, const std::string& depends)
    {
        ToldSentence sentence{ToldSentence::Kind::dependence, check.name, depends};
        for (const unsigned inputs : other_inputs) {
            const std::string again = with_asked(check, inputs, [&](const AskedCheck& asked, SpareTime& time) {
                return wrong_dependence(worker_, asked, time);
            });
            if (!again.empty()) note(sentence, again == depends);
        }
        return sentence;
    }

    /// Do the changes make wrong answers to other inputs right?
    ToldSentence tried_changes(const Check& check, const std::vector<OtherQuestion>& changes, const std::string& words)
    {
        ToldSentence sentence{ToldSentence::Kind::change, check.name, words};
        for (const unsigned inputs : other_inputs) {
            const std::uint64_t seed = options_for(inputs).seeds.seed_of(exercise_, check.case_name);
            with_asked(check, inputs, [&](const AskedCheck& asked, SpareTime& time) {
                for (const OtherQuestion& change : changes)
                    if (const auto holds = is_right_with(worker_, asked, seed, change, time)) note(sentence, *holds);
            });
        }
        return sentence;
    }

    /// What wrong answers depend on, and what makes them right.
    void try_depends(const Check& check, std::string depends, UnforeseenBug& bug)
    {
        if (const std::size_t place = depends.find(right_with_words); place != std::string::npos) {
            const std::string told = depends.substr(place);
            auto changes = with_asked(check, seen_inputs, [&](const AskedCheck& asked, SpareTime& time) {
                return changes_that_make_right(worker_, asked, time);
            });
            // There is more time to find some here.
            std::erase_if(changes, [&](const OtherQuestion& change) {
                return told.find(in_words(change, headers_)) == std::string::npos;
            });
            bug.said.push_back(tried_changes(check, changes, told));
            depends.resize(place);
        }
        if (depends.ends_with("; ")) depends.resize(depends.size() - 2);
        if (!depends.empty()) bug.said.push_back(tried_dependence(check, depends));
    }

    /// What is said of a check's wrong answers.
    void try_common(const Check& check, UnforeseenBug& bug)
    {
        with_asked(check, seen_inputs, [&](const AskedCheck& asked, SpareTime& time) {
            const InCommon common = find_in_common(worker_, asked, time);
            if (common.condition)
                bug.said.push_back(
                    tried(asked, *common.condition, ToldSentence::Kind::condition, common.condition->condition.words));
            if (!common.answer.words.empty())
                bug.said.push_back(tried(asked, common.answer.words, ToldSentence::Kind::answer, common.answer.words));
        });
    }

    template <class Pattern>
    ToldSentence tried(const AskedCheck& asked, const Pattern& pattern, ToldSentence::Kind kind,
                       const std::string& words)
    {
        ToldSentence sentence{kind, asked.check.name, words};
        for (const unsigned inputs : other_inputs) {
            const std::uint64_t seed = options_for(inputs).seeds.seed_of(exercise_, asked.check.case_name);
            const std::optional<bool> holds = holds_at(worker_, asked, pattern, seed);
            if (holds) note(sentence, *holds);
        }
        return sentence;
    }

    Worker& worker_;
    const Exercise& exercise_;
    std::string headers_;
    Built built_;
};

std::string in_words(const Mutant& mutant) { return fmt::format("line {}: {}", mutant.line, mutant.change); }

/// Mutants in an order that follows from the seed.
std::vector<Mutant> shuffled(std::vector<Mutant> mutants, Random& random)
{
    for (std::size_t i = mutants.size(); i > 1; --i)
        std::swap(mutants[i - 1], mutants[random.below(static_cast<std::uint32_t>(i))]);
    return mutants;
}

}

std::vector<UnforeseenBug> explain_unforeseen(Worker& worker, const Exercise& exercise,
                                              const std::filesystem::path& finder, const UnforeseenPlan& plan)
{
    const ScratchFolder work(worker.tools().cache);
    const Sources sources = reference_sources(worker.tools().reference, exercise);
    const auto& [name, source] = *sources.begin();
    const BuiltMutants built =
        build_mutants(worker.tools(), exercise, MutantFamily::syntax, finder, source, work.path());
    Random random(case_seed("unforeseen", "", "", exercise.id, "", plan.seed));
    const std::vector<Mutant> mutants = shuffled(built.mutants, random);
    Trial trial(worker, exercise, built.library);
    std::vector<UnforeseenBug> bugs;
    std::size_t next = 0;
    for (unsigned found = 0, tried = 0; found < plan.bugs && tried < most_tries * plan.bugs && next < mutants.size();
         ++tried, ++next) {
        worker.let_go();
        Sources files = sources;
        files[name] = with_change(source, mutants[next]);
        std::optional<UnforeseenBug> bug = trial.explain(mutants[next].number, std::move(files), mutants[next].line);
        if (!bug) continue;
        bug->bug = in_words(mutants[next]);
        bugs.push_back(std::move(*bug));
        ++found;
    }
    for (unsigned found = 0, tried = 0; found < plan.pairs && tried < plan.pairs && next + 1 < mutants.size();
         ++tried, next += 2) {
        worker.let_go();
        std::optional<UnforeseenBug> bug = trial.explain(both(mutants[next].number, mutants[next + 1].number));
        if (!bug) continue;
        bug->bug = in_words(mutants[next]) + "; " + in_words(mutants[next + 1]);
        bug->two = true;
        bugs.push_back(std::move(*bug));
        ++found;
    }
    return bugs;
}

}
