#include "question/answer_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "question/alike.hpp"
#include "question/answer_columns.hpp"
#include "question/wrong_numbers.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_named = 4;  ///< more numbers of a row than that are no pattern

/// The column, or the row, of a square matrix in which all these entries lie; empty if there is none.
std::string line_of_matrix(std::size_t components, const std::vector<std::size_t>& which)
{
    const std::size_t side = components == 16 ? 4 : 3;
    const auto all_in = [&](auto line) {
        return std::ranges::all_of(which, [&](std::size_t i) { return line(i) == line(which.front()); });
    };
    const auto column = [side](std::size_t i) { return i / side; };
    const auto row = [side](std::size_t i) { return i % side; };
    if (all_in(column)) return fmt::format("column {}", column(which.front()));
    if (all_in(row)) return fmt::format("row {}", row(which.front()));
    return "";
}

bool is_matrix(const AnswerTable& table)
{
    const bool square = table.components == 9 || table.components == 16;
    return square && table.columns.size() == table.components && table.columns.front().starts_with("entry ");
}

/// Is this number the least of each wrong row, on both sides?
bool is_least_in_rows(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong, std::size_t number)
{
    const auto is_least = [&](const std::vector<double>& rows) {
        for (std::size_t at = 0; at + table.components <= rows.size(); at += table.components)
            for (std::size_t i = table.keys; i < table.components; ++i)
                if (rows[at + i] < rows[at + number]) return false;
        return true;
    };
    return std::ranges::all_of(wrong,
                               [&](const AnswerPair* one) { return is_least(one->yours) && is_least(one->expected); });
}

}

std::vector<std::size_t> wrong_components(const std::vector<const AnswerPair*>& wrong, std::size_t components)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < components; ++i)
        if (std::ranges::any_of(wrong, [&](const AnswerPair* one) {
                const double size = size_of(one->expected);
                for (std::size_t at = i; at < one->yours.size(); at += components)
                    if (!alike(one->yours[at], one->expected[at], size)) return true;
                return false;
            }))
            found.push_back(i);
    return found;
}

std::string place_of(const AnswerTable& table, const std::vector<std::size_t>& which,
                     const std::vector<std::string>& columns)
{
    if (which.empty() || which.size() > most_named || 2 * which.size() > table.components - table.keys) return "";
    if (which.size() > 1) {
        if (table.picture) return "";
        // Nobody can count along a row whose numbers have no names, and that begins with what is no number of its own.
        if (table.keys > 0 && columns.empty()) return "";
        if (is_matrix(table)) {
            const std::string line = line_of_matrix(table.components, which);
            return line.empty() ? "" : fmt::format("differs in {} only", line);
        }
    }
    for (const NumbersTogether& group : together(columns))
        if (which.size() > 1 && group.size == which.size() && group.first == which.front() &&
            which.back() - which.front() == group.size - 1)
            return fmt::format("differs in {} only", group.name);
    std::vector<std::string> names;
    for (const std::size_t i : which)
        names.push_back(i < columns.size()                  ? columns[i]
                        : table.keys > 0 && i >= table.keys ? fmt::format("its number {}", i - table.keys + 1)
                                                            : fmt::format("number {}", i));
    return which.size() == 1 ? fmt::format("differs in {} only", names.front())
                             : fmt::format("differs in nothing but {}", fmt::join(names, ", "));
}

std::string all_but_one(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong,
                        const std::vector<std::size_t>& which, const std::vector<std::string>& columns)
{
    constexpr std::size_t least_values = 4;
    const std::size_t numbers = table.components - table.keys;
    if (numbers < 3 || which.size() + 1 != numbers || columns.size() != table.components || table.picture) return {};
    std::size_t right = table.keys;
    while (std::ranges::find(which, right) != which.end()) ++right;
    if (right == table.components || which.front() < table.keys) return {};
    // The first number is often what the row is about, or how many others there are.
    if (right == table.keys && columns[right].size() > 1) return {};
    const NumberPairs same = numbers_in(wrong, table.components, {right});
    if (std::set(same.right.begin(), same.right.end()).size() < least_values) return {};
    if (is_least_in_rows(table, wrong, right)) return {};
    return "differs in other numbers than " + columns[right];
}

}
