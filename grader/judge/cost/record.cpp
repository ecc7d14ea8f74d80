#include <cmath>

#include "judge/controls.hpp"
#include "judge/cost/cost.hpp"
#include "judge/cost/rule.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judge_record.hpp"
#include "judge/parameters.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"
#include "text/field.hpp"

namespace umbral::grader {
namespace {

void read_growth(const Field& check, Check& to)
{
    CostParameters parameters{check.member("growth").number(0, 8)};
    if (const Field after = check.member("after"); after.given()) parameters.after = after.text(64);
    to.own = std::move(parameters);
}

// A function that does nothing, whatever the size: one block.
Tensor at_once(const Tensor& expected)
{
    std::vector<double> values = to_doubles(expected);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % expected.components > 0) values[i] = 1;
    return with_values(expected, values);
}

Controls cost_controls(const Check& /*check*/, const Tensor& expected, std::uint64_t /*seed*/)
{
    return {{"zeros", filled(expected, std::vector<double>(expected.components, 0))},
            {"returns at once", at_once(expected)}};
}

Resemblance same_cost(const FailingCheck& failing, const Tensor& mistake)
{
    for (const Tensor* tensor : {failing.student, &mistake})
        if (fraction_right(*failing.check, *tensor, *failing.expected, nullptr) >= 1) return not_alike;
    const auto a = comparable_growth(*failing.student, *failing.expected);
    const auto b = comparable_growth(mistake, *failing.expected);
    if (a.has_value() != b.has_value() || (a && std::abs(*a - *b) > thresholds::same_growth)) return not_alike;
    return alike(2, !a);
}

Evidence cost_evidence(const Check& check, const Observation& observation, bool right)
{
    if (right || observation.expected->components != 2) return {};
    const TensorView yours(*observation.yours);
    const TensorView expected(*observation.expected);
    CostEvidence evidence;
    evidence.growth = parameters_of<CostParameters>(check).growth;
    for (std::size_t i = 0; i < expected.cells(); ++i) {
        CostPoint point;
        point.size = expected.cell(i)[0];
        point.reference = expected.cell(i)[1];
        if (i < yours.cells() && yours.components() == 2) point.yours = yours.cell(i)[1];
        evidence.points.push_back(point);
    }
    return evidence;
}

constexpr OwnField fields_of_cost[] = {{"growth", R"({
  "description": "Costs: the largest exponent of the size with which the count may grow.",
  "type": "number",
  "minimum": 0,
  "maximum": 8
})"},
                                       {"after",
                                        R"({
  "description": "Costs: another table of the case whose work on a size this one's needs, as asking a tree needs )"
                                        R"(building it. What that takes is not laid on this one, when it )"
                                        R"(is measured from outside.",
  "type": "string"
})",
                                        true}};

}

extern constinit const JudgeRecord cost_judge;
constinit const JudgeRecord cost_judge{
    .name = "cost",
    .place = 3,
    .compares = "how counted work grows",
    .own_fields = fields_of_cost,
    .read_own = read_growth,
    .free_rows = true,
    .plain_values = false,
    .counts_work = true,
    .judge = [](const Question& q) { return judge_cost(q.check, q.student, q.expected, q.names); },
    .controls = cost_controls,
    .resemblance = same_cost,
    .evidence = cost_evidence,
};

}
