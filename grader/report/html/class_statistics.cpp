#include "report/html/class_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "report/hidden.hpp"

namespace umbral::grader::html {
namespace {

double median_of(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}

std::vector<UnitStatistics> unit_statistics(const ClassResult& result)
{
    std::vector<UnitStatistics> all;
    std::map<std::string, std::size_t> index;
    std::vector<std::vector<double>> shares;
    for (const SubmissionResult& submission : result.submissions)
        for (const UnitResult& unit : submission.units) {
            const auto [found, added] = index.emplace(unit.id, all.size());
            if (added) {
                all.emplace_back().id = unit.id;
                shares.emplace_back();
            }
            if (unit.verdict == Verdict::grader_fault || unit.max_score <= 0) continue;
            UnitStatistics& one = all[found->second];
            const double share =
                std::clamp(static_cast<double>(unit.score) / static_cast<double>(unit.max_score), 0.0, 1.0);
            one.max_score = std::max(one.max_score, unit.max_score);
            ++one.graded;
            if (all_right(unit)) ++one.right;
            // What is not nothing never counts as nothing, nor what is not all as all.
            const std::size_t place =
                unit.score <= 0 ? 0
                : unit.score >= unit.max_score
                    ? 10
                    : std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(10 * share)), 1, 9);
            ++one.by_share[place];
            shares[found->second].push_back(share);
        }
    for (std::size_t i = 0; i < all.size(); ++i) all[i].median = median_of(std::move(shares[i]));
    return all;
}

}
