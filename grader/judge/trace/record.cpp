#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/controls.hpp"
#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judge_record.hpp"
#include "judge/parameters.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"
#include "judge/trace/draw_faults.hpp"
#include "judge/trace/rule.hpp"
#include "judge/trace/trace_counts.hpp"
#include "text/field.hpp"

namespace umbral::grader {
namespace {

void read_rules(const Field& check, Check& to)
{
    const Field field = check.member("rules");
    TraceParameters parameters{field.texts(1, trace_rules.size(), 40)};
    std::set<std::string> seen;
    for (const std::string& rule : parameters.rules)
        if (std::ranges::find(trace_rules, rule) == trace_rules.end() || !seen.insert(rule).second)
            field.refuse(fmt::format("each once, some of \"{}\" (not '{}')", fmt::join(trace_rules, "\", \""), rule));
    to.own = std::move(parameters);
}

Tensor without_rows(const Tensor& expected)
{
    Tensor tensor = expected;
    tensor.rows = 0;
    tensor.bytes.clear();
    tensor.present.clear();
    return tensor;
}

/// "glBufferData(GL_ARRAY_BUFFER, …), 128 bytes"
std::vector<std::string> call_lines(const GlTrace& trace, bool& cut)
{
    std::vector<std::string> lines;
    for (const GlCall& call : trace.calls) {
        if (lines.size() == most_compared_lines) {
            cut = true;
            break;
        }
        lines.push_back(in_cpp(call) + (call.bytes > 0 ? fmt::format(", {} bytes", call.bytes) : ""));
    }
    return lines;
}

Evidence trace_evidence(const Check& /*check*/, const Observation& observation, bool right)
{
    if (right) return {};
    const std::optional<GlTrace> mine = parse_gl_trace(text_of(observation.yours));
    const std::optional<GlTrace> theirs = parse_gl_trace(text_of(observation.expected));
    if (!mine || !theirs) return {};
    bool cut = mine->truncated || theirs->truncated;
    Sides sides{call_lines(*mine, cut), call_lines(*theirs, cut), {}};
    // Object numbers are each program's own; how much is uploaded is not.
    sides.alignment = align(sides.yours.size(), sides.expected.size(), [&](std::size_t i, std::size_t j) {
        return same_call(mine->calls[i], theirs->calls[j]) && mine->calls[i].bytes == theirs->calls[j].bytes;
    });
    return lines_evidence(sides, "Calls", cut);
}

// Whatever the calls are: the same counts break the same rules for the same reason.
Resemblance same_trace(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const auto yours = parse_gl_trace(text_of(failing.student));
    const auto mistake = parse_gl_trace(text_of(&mistake_tensor));
    const auto expected = parse_gl_trace(text_of(failing.expected));
    if (!yours || !mistake || !expected ||
        fraction_right(*failing.check, *failing.student, *failing.expected, nullptr) >= 1)
        return not_alike;
    const auto& rules = parameters_of<TraceParameters>(*failing.check).rules;
    if (!std::ranges::all_of(rules,
                             [&](const std::string& rule) { return counted(*yours, rule) == counted(*mistake, rule); }))
        return not_alike;
    // Each count that differs from the expected one is a number that could have been another.
    std::size_t telling = 0;
    for (const std::string& rule : rules) telling += counted(*yours, rule) != counted(*expected, rule) ? 1 : 0;
    return alike(2 * telling, counted(*yours, "draw calls") == 0 && counted(*expected, "draw calls") > 0);
}

// A draw call that takes data where there are none is wrong, whatever the calls' counts are.
// One is enough: others may follow from it.
std::optional<Explanation> fault_of_draws(const FailingCheck& one)
{
    const auto yours = parse_gl_trace(text_of(one.student));
    const auto expected = parse_gl_trace(text_of(one.expected));
    if (!yours || !expected) return std::nullopt;
    std::vector<DrawFault> faults = draw_faults(*yours, *expected);
    if (faults.empty()) return std::nullopt;
    return Explanation{std::move(faults.front().name), std::move(faults.front().sentence), thresholds::very_sure};
}

constexpr OwnField fields_of_trace[] = {{"rules", R"({
  "description": "Traces: what is counted against the reference.",
  "type": "array",
  "items": {
    "enum": ["draw calls", "vertices", "uploaded bytes", "objects created", "objects deleted", "deprecated calls",
             "state changes"]
  },
  "minItems": 1,
  "maxItems": 7,
  "uniqueItems": true
})"}};

}

extern constinit const JudgeRecord trace_judge;
constinit const JudgeRecord trace_judge{
    .name = "trace",
    .place = 0,
    .compares = "traces of OpenGL calls",
    .own_fields = fields_of_trace,
    .read_own = read_rules,
    .free_rows = true,
    .plain_values = false,
    .more_cells = caps::trace_bytes,
    .is_of_drawing = true,
    .judge = [](const Question& q) { return judge_trace(q.check, q.student, q.expected); },
    .controls =
        [](const Check&, const Tensor& expected, std::uint64_t) {
            return Controls{{"no call", without_rows(expected)}};
        },
    .resemblance = same_trace,
    .fault = fault_of_draws,
    .evidence = trace_evidence,
};

}
