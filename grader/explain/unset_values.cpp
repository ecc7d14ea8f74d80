#include "explain/unset_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "build/with_zeros.hpp"
#include "explain/explained_checks.hpp"
#include "explain/same_values.hpp"
#include "judge/judges.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

/// Each is run twice.
constexpr std::size_t most_cases = 4;
constexpr std::size_t most_warnings = 2;
constexpr std::size_t most_letters = 160;
/// Only chance could have it otherwise: one that two runs which differ, and two which do not, leave room for.
constexpr double confidence_of_difference = 0.99;

/// A case, and the values that its failing checks look at. Counted work may depend on how variables are filled. A case
/// that was stopped by the clock would be stopped again, whatever variables hold, and is not run.
struct FailingCase {
    std::string name;
    bool hidden = false;
    std::set<std::string> values{};
};

std::vector<FailingCase> failing_cases(const Exercise& exercise, const UnitResult& result, const CaseResults& cases)
{
    std::vector<FailingCase> found;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        if (result.checks[i].score == result.checks[i].max_score || !one.reached || judge_of(check).counts_work ||
            one.student.verdict == Verdict::timeout)
            continue;
        auto at = std::ranges::find(found, check.case_name, &FailingCase::name);
        if (at == found.end()) at = found.insert(found.end(), {check.case_name, one.hidden});
        const std::vector<std::string> values = values_of(check);
        at->values.insert(values.begin(), values.end());
    }
    std::ranges::stable_sort(found, std::less<>(), &FailingCase::hidden);
    if (found.size() > most_cases) found.resize(most_cases);
    return found;
}

bool differ(const RunOutcome& a, const RunOutcome& b, const FailingCase& of)
{
    // The build with zeros is slower.
    if (a.verdict == Verdict::timeout || b.verdict == Verdict::timeout) return false;
    if (a.verdict != b.verdict) return true;
    return std::ranges::any_of(of.values, [&](const std::string& value) {
        const Tensor* in_a = tensor_of(a, value);
        const Tensor* in_b = tensor_of(b, value);
        return in_a == nullptr || in_b == nullptr ? in_a != in_b : !are_same_values(*in_a, *in_b);
    });
}

/// Is it the compiler's own, about one of these files? What #warning writes may hold any words, but ends with [-Wcpp];
/// #line gives a file any name.
bool is_of_unset(const std::string& line, const Exercise& exercise)
{
    const bool in_file =
        std::ranges::any_of(exercise.files, [&](const std::string& file) { return line.starts_with(file + ":"); });
    return in_file && (line.ends_with(" [-Wuninitialized]") || line.ends_with(" [-Wmaybe-uninitialized]"));
}

/// "g++: sphere.cpp:3:9: 'sum' is used uninitialized" for the first of the compiler's warnings of this kind.
std::string quoted(const std::string& warnings, const Exercise& exercise)
{
    constexpr std::string_view sign = " warning:";
    std::istringstream lines(warnings);
    std::string all;
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line) && count < most_warnings;) {
        const std::size_t at = line.find(sign);
        if (at == std::string::npos || !is_of_unset(line, exercise)) continue;
        line.erase(at, sign.size());
        all += fmt::format("g++: {}\n", one_line(line.substr(0, line.rfind(" [-W")), most_letters));
        ++count;
    }
    return all;
}

}

std::optional<UnsetValues> by_unset_values(Worker& worker, const Exercise& exercise, const Built& built,
                                           const UnitResult& result, const CaseResults& cases)
{
    if (is_explained(result) || built.files.empty()) return std::nullopt;
    const std::vector<FailingCase> failing = failing_cases(exercise, result, cases);
    if (failing.empty()) return std::nullopt;
    const std::optional<Built> zeros = build_with_zeros(worker.tools(), exercise, built);
    if (!zeros || zeros->verdict != Verdict::ok) return std::nullopt;
    Built nonsense = built;
    nonsense.fresh_memory = FreshMemory::lasting_nonsense;
    for (const FailingCase& one : failing) {
        if (!worker.spare_time().is_left()) return std::nullopt;
        const CaseResult& graded = cases.at(one.name);
        const auto run = [&](const Built& what) { return worker.run_again(exercise, what, one.name, graded.seed); };
        const RunOutcome first = run(nonsense);
        if (!differ(first, run(*zeros), one)) continue;
        if (differ(first, run(nonsense), one)) return std::nullopt;
        const char* const sentence =
            "Your program reads a variable, or memory, to which it never gave a value, that lies behind the end of a "
            "list, or that is gone already (a reference to an argument, after the call): where that holds zeros "
            "instead, its answers are different.";
        return UnsetValues{{"uninitialized", sentence, confidence_of_difference, 1, false, one.hidden},
                           one.hidden ? "" : quoted(zeros->message, exercise)};
    }
    return std::nullopt;
}

}
