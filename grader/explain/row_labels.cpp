#include "explain/row_labels.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace umbral::grader {

bool is_label(const AskedAnswers& answers, std::size_t component)
{
    constexpr std::size_t least_labels = 3;
    constexpr std::size_t least_rows = 3;
    if (component >= answers.columns.size() || answers.components < 2) return false;
    std::set<double> labels;
    std::set<std::uint32_t> questions;
    for (const AskedAnswer& one : answers.all) {
        questions.insert(one.question);
        const std::vector<double>& yours = one.answer.yours;
        const std::vector<double>& expected = one.answer.expected;
        if (expected.size() <= component || yours.size() <= component) return false;
        if (yours[component] != expected[component] || expected[component] != std::round(expected[component]))
            return false;
        labels.insert(expected[component]);
    }
    return labels.size() >= least_labels && answers.all.size() >= least_rows * questions.size();
}

}
