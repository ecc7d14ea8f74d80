#include "unit/troubles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "model/caps.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

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

}

std::string troubles(const CaseResults& cases)
{
    std::map<std::string, std::vector<std::string>> by_cause;
    for (const auto& [name, one] : cases)
        if (std::string cause = cause_of(one); !cause.empty()) by_cause[std::move(cause)].push_back(name);
    std::string lines;
    for (const auto& [cause, names] : by_cause) lines += fmt::format("{}: {}\n", fmt::join(names, ", "), cause);
    return printable(lines, caps::message);
}

}
