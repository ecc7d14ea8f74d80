#include "explain/by_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "explain/some_rows.hpp"
#include "judge/explain/thresholds.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

double share_of(const AnswersOfOne& answers, const FunctionParts& parts)
{
    return static_cast<double>(answers.its_alone) / static_cast<double>(parts.failing);
}

/// What a part of a check says of a candidate's run.
Resemblance says_of_part(const PartOfCheck& one, const RunOutcome& its)
{
    if (one.rows.empty()) return says_of(one.part, *one.group->result, its);
    const Tensor* const table = its.verdict == Verdict::ok ? observed(*one.whole, its) : nullptr;
    if (table == nullptr || one.part.student == nullptr || one.part.expected == nullptr || !well_formed(*table) ||
        table->rows <= one.rows.back() || table->columns != 1)
        return not_alike;
    return resemblance(one.part, some_rows(*table, one.rows));
}

/// What all answers of a function say of a mistake; nothing if any speaks against it, or the first that fails says
/// nothing.
std::optional<Tally> tally_of(Worker& worker, const Exercise& exercise, const AnswersOfOne& answers,
                              const KnownSolution& mistake)
{
    Tally tally;
    for (const PartOfCheck& one : answers.parts) {
        const RunOutcome& run = worker.run_known(exercise, mistake, one.group->name, one.group->result->seed);
        tally += says_of_part(one, run);
        if (tally.against_it > 0 || tally.for_it == 0) return std::nullopt;
    }
    return tally;
}

}

std::vector<Explanation> transforms_by_function(const FunctionParts& parts)
{
    std::vector<Explanation> found;
    for (const auto& [function, answers] : parts.functions) {
        if (!answers.beside_others) continue;
        std::vector<FailingCheck> tables;
        for (const PartOfCheck& one : answers.parts)
            if (!one.rows.empty()) tables.push_back(one.part);
        for (Explanation& one : explain_by_transform(tables)) {
            one.fit = std::min(one.fit, share_of(answers, parts));
            one.name += fmt::format(" in {}", reflect::last_name(function));
            one.sentence = sentence_about({function}, std::move(one.sentence));
            found.push_back(std::move(one));
        }
    }
    return found;
}

std::vector<Explanation> mistakes_by_function(Worker& worker, const Exercise& exercise, const FunctionParts& parts,
                                              std::span<const KnownSolution> mistakes)
{
    std::vector<Explanation> found;
    if (parts.functions.size() < 2) return found;
    for (const KnownSolution& mistake : mistakes) {
        std::vector<std::string> made_in;
        double share = 0;
        double sure = 1;
        for (const auto& [function, answers] : parts.functions) {
            if (!answers.parts.front().part.fails) continue;
            const std::optional<Tally> tally = tally_of(worker, exercise, answers, mistake);
            if (!tally || confidence(*tally) < thresholds::very_sure) continue;
            made_in.push_back(function);
            share += share_of(answers, parts);
            sure = std::min(sure, confidence(*tally));
        }
        if (!made_in.empty())
            found.push_back(
                {mistake_title(mistake.name), sentence_about(made_in, mistake.hint), sure, std::min(1.0, share)});
    }
    return found;
}

}
