#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "judge/parameters.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/trace/rule.hpp"
#include "judge/trace/trace_counts.hpp"

namespace umbral::grader {
namespace {

constexpr std::string_view draw_calls = "draw calls";
constexpr std::string_view vertices = "vertices";
constexpr std::string_view uploaded_bytes = "uploaded bytes";
constexpr std::string_view objects_made = "objects created";
constexpr std::string_view objects_gone = "objects deleted";
constexpr std::string_view deprecated_calls = "deprecated calls";
constexpr std::string_view state_changes = "state changes";

/// By how much numbers of smaller types may shrink a table: half a float takes 2 bytes of 4, an index may take 1 of 4.
constexpr double smallest_types = 3;

/// The first call that a rule counts of a function that is called more often than expected; null if there is none.
const GlCall* first_extra(const GlTrace& trace, const GlTrace& expected, std::string_view rule)
{
    std::map<std::string_view, std::ptrdiff_t> more;
    for (const GlCall& call : trace.calls) ++more[call.name];
    for (const GlCall& call : expected.calls) --more[call.name];
    const auto found = std::ranges::find_if(
        trace.calls, [&](const GlCall& call) { return more.at(call.name) > 0 && share_of(call, rule) > 0; });
    return found == trace.calls.end() ? nullptr : &*found;
}

/// What a teacher says of a broken rule.
std::string complaint(std::string_view rule, double yours, double expected, const GlTrace& trace,
                      const GlTrace& expected_trace)
{
    const auto number = [](double count, const char* one, const char* many) {
        return fmt::format("{} {}", count_text(count), count == 1 ? one : many);
    };
    const char* possible = expected == 1 ? "is" : "are";
    if (rule == draw_calls)
        return fmt::format("{}, {} {} possible", number(yours, "draw call", "draw calls"), count_text(expected),
                           possible);
    if (rule == vertices)
        return fmt::format("{} drawn, expected {}", number(yours, "vertex is", "vertices are"), count_text(expected));
    if (rule == uploaded_bytes && expected == 0)
        return fmt::format("data is uploaded again: {}, 0 are needed", number(yours, "byte", "bytes"));
    if (rule == uploaded_bytes && yours < expected)
        return fmt::format("{} uploaded, of the {} that are needed", number(yours, "byte is", "bytes are"),
                           count_text(expected));
    if (rule == uploaded_bytes)
        return fmt::format("{} uploaded, {} {} needed", number(yours, "byte is", "bytes are"), count_text(expected),
                           possible);
    if (rule == objects_made)
        return fmt::format("{} created, expected {}", number(yours, "object is", "objects are"), count_text(expected));
    if (rule == objects_gone)
        return fmt::format("{} deleted, expected {}", number(yours, "object is", "objects are"), count_text(expected));
    if (rule == state_changes)
        return fmt::format("{}, {} {} enough", number(yours, "state change", "state changes"), count_text(expected),
                           possible);
    const GlCall* call = first_extra(trace, expected_trace, rule);
    if (call == nullptr) return "";
    // Where such calls are what is asked for, only how many there are can be wrong.
    if (std::ranges::find(expected_trace.calls, call->name, &GlCall::name) != expected_trace.calls.end())
        return fmt::format("{} of the fixed function, {} are enough", number(yours, "call", "calls"),
                           count_text(expected));
    return fmt::format("{} is deprecated: {}", call->name, instead_of_deprecated(call->name));
}

/// The calls that a rule looks at, with their places in the trace.
struct Looked {
    const GlCall* call;
    std::size_t index;
};

std::vector<Looked> looked_at(const GlTrace& trace, std::string_view rule)
{
    std::vector<Looked> calls;
    for (std::size_t i = 0; i < trace.calls.size(); ++i)
        if (share_of(trace.calls[i], rule) > 0 || (rule == vertices && draws(trace.calls[i])))
            calls.push_back({&trace.calls[i], i});
    return calls;
}

/// What draws, and how many vertices: a call, or all between a glBegin and its glEnd.
struct Drawing {
    std::string text;
    std::size_t index;
    double vertices = 0;
};

std::vector<Drawing> drawings_in(const GlTrace& trace)
{
    std::vector<Drawing> drawings;
    for (std::size_t i = 0; i < trace.calls.size(); ++i) {
        const GlCall& call = trace.calls[i];
        if (draws(call))
            drawings.push_back({in_cpp(call), i, vertices_of(call)});
        else if (!drawings.empty())
            drawings.back().vertices += vertices_of(call);
    }
    return drawings;
}

/// The first of as many drawings in the same order that has another number of vertices.
std::optional<Difference> first_other_count(const GlTrace& yours, const GlTrace& expected)
{
    const std::vector<Drawing> a = drawings_in(yours);
    const std::vector<Drawing> b = drawings_in(expected);
    if (a.size() != b.size()) return std::nullopt;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].vertices == b[i].vertices) continue;
        const auto text = [](const Drawing& one) {
            return fmt::format("{}: {} {}", one.text, count_text(one.vertices),
                               one.vertices == 1 ? "vertex" : "vertices");
        };
        return Difference{fmt::format("vertices: call {} of your {}", a[i].index + 1, yours.calls.size()), text(a[i]),
                          text(b[i])};
    }
    return std::nullopt;
}

std::optional<Difference> first_difference(std::string_view rule, const GlTrace& yours, const GlTrace& expected)
{
    if (rule == vertices)
        if (auto found = first_other_count(yours, expected)) return found;
    const std::vector<Looked> a = looked_at(yours, rule);
    const std::vector<Looked> b = looked_at(expected, rule);
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        if (i < a.size() && i < b.size() && same_call(*a[i].call, *b[i].call)) continue;
        const std::string where = i < a.size() ? fmt::format("call {} of your {}", a[i].index + 1, yours.calls.size())
                                  : a.empty()  ? "you make no such call"
                                               : "after your last such call";
        return Difference{fmt::format("{}: {}", rule, where), i < a.size() ? in_cpp(*a[i].call) : "nothing",
                          i < b.size() ? in_cpp(*b[i].call) : "nothing"};
    }
    return std::nullopt;
}

}

double share_of(const GlCall& call, std::string_view rule)
{
    if (rule == draw_calls) return draws(call) ? 1 : 0;
    if (rule == vertices) return vertices_of(call);
    if (rule == uploaded_bytes) return static_cast<double>(call.bytes);
    if (rule == objects_made) return objects_created(call);
    if (rule == objects_gone) return objects_deleted(call);
    if (rule == deprecated_calls) return instead_of_deprecated(call.name) != nullptr ? 1 : 0;
    if (rule == state_changes) return changes_state(call) ? 1 : 0;
    throw std::invalid_argument(
        fmt::format("expected one of the rules \"{}\", got \"{}\"", fmt::join(trace_rules, "\", \""), rule));
}

double counted(const GlTrace& trace, std::string_view rule)
{
    double sum = 0;
    for (const GlCall& call : trace.calls) sum += share_of(call, rule);
    return sum;
}

bool keeps(std::string_view rule, double yours, double expected)
{
    if (rule == vertices || rule == objects_made || rule == objects_gone) return yours == expected;
    if (rule == uploaded_bytes && yours * smallest_types < expected) return false;
    return yours <= expected;
}

Judgement judge_trace(const Check& check, const Tensor& student, const Tensor& expected_tensor)
{
    const auto fault = [&](const char* what) { throw std::invalid_argument("check '" + check.name + "': " + what); };
    const std::vector<std::string>& wanted = parameters_of<TraceParameters>(check).rules;
    if (wanted.empty()) fault("a trace is judged by at least one rule");
    const auto expected = parse_gl_trace(text_of(&expected_tensor));
    if (!expected || expected->truncated) fault("the expected trace is none of record_trace, or holds too many calls");
    const auto yours = parse_gl_trace(text_of(&student));
    Judgement judgement;
    if (!yours) {
        judgement.message = "the recorded calls are damaged: the run was disturbed";
        return judgement;
    }
    std::vector<std::string> complaints;
    for (const std::string& rule : wanted) {
        const double mine = counted(*yours, rule);
        const double theirs = counted(*expected, rule);
        std::string key = rule;
        std::ranges::replace(key, ' ', '_');
        judgement.metrics[key] = mine;
        judgement.metrics["expected_" + key] = theirs;
        if (keeps(rule, mine, theirs)) continue;
        complaints.push_back(complaint(rule, mine, theirs, *yours, *expected));
        if (!judgement.first_difference) judgement.first_difference = first_difference(rule, *yours, *expected);
    }
    const auto rules = static_cast<double>(wanted.size());
    judgement.right = (rules - static_cast<double>(complaints.size())) / rules;
    // What follows is said before all else.
    std::vector<std::string> first;
    if (counted(*yours, draw_calls) == 0 && counted(*expected, draw_calls) > 0) {
        first.emplace_back("nothing is drawn");
        judgement.right = 0;
        judgement.first_difference = first_difference(draw_calls, *yours, *expected);
    }
    if (yours->truncated) {
        first.push_back(fmt::format("more than {} calls, {} are enough",
                                    count_text(static_cast<double>(yours->calls.size())),
                                    count_text(static_cast<double>(expected->calls.size()))));
        judgement.right = 0;
    }
    std::ranges::move(complaints, std::back_inserter(first));
    judgement.message = fmt::format("{}", fmt::join(first, "; "));
    return judgement;
}

}
