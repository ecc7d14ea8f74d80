#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "judge/cost/cost.hpp"
#include "judge/cost/rule.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/parameters.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

std::string fold_text(const Cost& cost)
{
    const double fold = cost.back().blocks / cost.front().blocks;
    return fold < 10 ? fmt::format("{:.1f}-fold", fold) : count_text(fold) + "-fold";
}

std::string growth_text(double exponent)
{
    if (exponent == 0) return "no growth at all";
    if (exponent == 1) return "linear";
    if (exponent == 2) return "quadratic";
    return fmt::format("n^{:.1f}", exponent);
}

/// Why the rows say nothing about growth; empty if they do.
std::string trouble(const Cost& yours, const Cost& reference)
{
    for (std::size_t i = 0; i < reference.size(); ++i)
        if (i >= yours.size() || yours[i].size != reference[i].size)
            return fmt::format("no work was counted for the size {}", count_text(reference[i].size));
    if (yours.size() > reference.size()) return "more sizes were counted than the driver tries: the run was disturbed";
    for (const CostRow& row : yours)
        if (!std::isfinite(row.blocks) || row.blocks < 0) return "the counts are damaged: the run was disturbed";
    const double least = std::max(thresholds::least_blocks, thresholds::least_work * reference.back().blocks);
    const bool idle =
        std::ranges::any_of(yours, [](const CostRow& row) { return row.blocks == 0; }) || yours.back().blocks < least;
    return idle ? fmt::format("next to nothing is done: {} steps for the size {}, the reference takes {}",
                              count_text(yours.back().blocks), count_text(yours.back().size),
                              count_text(reference.back().blocks))
                : "";
}

}

std::optional<Cost> cost_of(const Tensor& tensor)
{
    if (tensor.element != Element::float64 || tensor.components != 2 || tensor.columns != 1) return std::nullopt;
    const TensorView view(tensor);
    Cost cost;
    for (std::size_t i = 0; i < view.cells(); ++i) cost.push_back({view.cell(i)[0], view.cell(i)[1]});
    return cost;
}

double growth_of(const Cost& cost)
{
    double mean_x = 0;
    double mean_y = 0;
    for (const CostRow& row : cost) mean_x += std::log(row.size), mean_y += std::log(row.blocks);
    mean_x /= static_cast<double>(cost.size());
    mean_y /= static_cast<double>(cost.size());
    double xy = 0;
    double xx = 0;
    for (const CostRow& row : cost) {
        const double x = std::log(row.size) - mean_x;
        xy += x * (std::log(row.blocks) - mean_y);
        xx += x * x;
    }
    return xy / xx;
}

std::optional<double> comparable_growth(const Tensor& tensor, const Tensor& expected)
{
    const auto yours = cost_of(tensor);
    const auto reference = cost_of(expected);
    if (!yours || !reference || reference->empty() || !trouble(*yours, *reference).empty()) return std::nullopt;
    return growth_of(*yours);
}

Judgement judge_cost(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names)
{
    const auto fault = [&](const char* what) { throw std::invalid_argument("check '" + check.name + "': " + what); };
    const auto reference = cost_of(expected);
    if (!reference) fault("costs are rows of two doubles, size and blocks, as record_cost writes them");
    if (reference->size() < 2) fault("growth needs at least two sizes");
    for (std::size_t i = 0; i < reference->size(); ++i) {
        const CostRow& row = (*reference)[i];
        if (!(row.size > 0 && std::isfinite(row.size) && row.blocks > 0 && std::isfinite(row.blocks)))
            fault("the reference's sizes and counts must be positive");
        if (i > 0 && row.size <= (*reference)[i - 1].size) fault("the sizes must increase");
    }
    Judgement judgement;
    const Cost yours = student.cells() == 0 ? Cost{} : *cost_of(student);
    judgement.message = trouble(yours, *reference);
    if (!judgement.message.empty()) return judgement;

    const double exponent = growth_of(yours);
    const double growth = parameters_of<CostParameters>(check).growth;
    const double excess = exponent - growth;
    judgement.right =
        std::clamp((thresholds::growth_zero - excess) / (thresholds::growth_zero - thresholds::growth_full), 0.0, 1.0);
    judgement.metrics = {{"exponent", exponent},
                         {"reference_exponent", growth_of(*reference)},
                         {"blocks_per_item", yours.back().blocks / yours.back().size},
                         {"reference_blocks_per_item", reference->back().blocks / reference->back().size}};
    if (judgement.right >= 1) return judgement;
    const std::string_view word = text_of(names);
    const std::string what(word.empty() ? "items" : word);
    judgement.message =
        fmt::format("from {} to {} {} your work grows {} (like n^{:.1f}); {} is possible (the reference: {})",
                    count_text(yours.front().size), count_text(yours.back().size), what, fold_text(yours), exponent,
                    growth_text(growth), fold_text(*reference));
    judgement.first_difference =
        Difference{fmt::format("{} {}", count_text(yours.back().size), what),
                   count_text(yours.back().blocks) + " steps", count_text(reference->back().blocks) + " steps"};
    return judgement;
}

}
