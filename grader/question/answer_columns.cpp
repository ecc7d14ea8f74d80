#include "question/answer_columns.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "question/alike.hpp"

namespace umbral::grader {

std::vector<std::string> columns_of_wrong_rows(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    if (!table.columns.empty() || table.kinds.empty()) return table.columns;
    std::optional<double> kind;
    for (const AnswerPair* const one : wrong)
        for (std::size_t at = 0; at < one->expected.size(); at += table.components) {
            const auto row = [&](const std::vector<double>& side) {
                return std::span(side).subspan(at, table.components);
            };
            if (alike_rows(row(one->yours), row(one->expected))) continue;
            if (kind && *kind != one->expected[at]) return {};
            kind = one->expected[at];
        }
    const auto found = kind ? table.kinds.find(*kind) : table.kinds.end();
    return found == table.kinds.end() ? std::vector<std::string>() : found->second.columns;
}

std::vector<NumbersTogether> together(const std::vector<std::string>& columns)
{
    std::vector<NumbersTogether> groups;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string name = columns[i].substr(0, columns[i].find_last_of(".["));
        if (!groups.empty() && !name.empty() && name != columns[i] && groups.back().name == name)
            ++groups.back().size;
        else
            groups.push_back({name, i, 1});
    }
    return groups;
}

}
