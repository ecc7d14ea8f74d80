#include "unit/troubles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "model/caps.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

/// All cases that one cause stopped, and the shortest question in which it did.
struct Trouble {
    std::vector<std::string> cases;
    std::string asked;
    std::string asked_in;
};

/// Empty if nothing was wrong.
std::string cause_of(const CaseResult& one)
{
    const bool refused = !one.student.refused.empty();
    if (one.hidden && one.reached && one.student.verdict != Verdict::ok)
        return std::string(in_words(one.student.verdict));
    if (one.is_stub()) return "a function that is asked there is not written yet";
    if (std::string cause = one.cause(); !cause.empty()) return cause;
    if (!refused) return "";
    return one.hidden ? "the sandbox refused calls" : "the sandbox refused " + listed(one.student.refused);
}

std::string line_of(const std::string& cause, const Trouble& trouble)
{
    std::string line = fmt::format("{}: {}", fmt::join(trouble.cases, ", "), cause);
    if (trouble.asked.empty()) return line;
    line += "; asked " + trouble.asked;
    if (trouble.cases.size() > 1) line += fmt::format(" (in {})", trouble.asked_in);
    return line;
}

}

std::string troubles(const CaseResults& cases)
{
    std::map<std::string, Trouble> by_cause;
    for (const auto& [name, one] : cases) {
        std::string cause = cause_of(one);
        if (cause.empty()) continue;
        Trouble& trouble = by_cause[std::move(cause)];
        trouble.cases.push_back(name);
        const std::string asked = one.hidden ? "" : one.question_of_end();
        if (asked.empty() || (!trouble.asked.empty() && trouble.asked.size() <= asked.size())) continue;
        trouble.asked = asked;
        trouble.asked_in = name;
    }
    std::string lines;
    for (const auto& [cause, trouble] : by_cause) lines += line_of(cause, trouble) + '\n';
    return printable(lines, caps::message);
}

}
