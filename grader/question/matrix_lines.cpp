#include "question/matrix_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "question/answer_relations.hpp"
#include "question/wrong_numbers.hpp"

namespace umbral::grader {
namespace {

using Pairs = std::vector<const AnswerPair*>;

/// Wrong matrices, of which a line is `side` numbers that follow each other: a column, or a row of transposed ones.
struct Lines {
    std::string_view name;
    const AnswerTable& table;
    const Pairs& wrong;
    std::size_t side;
    std::set<std::size_t> which;  ///< those that differ
    std::size_t count;            ///< how many of a line's numbers are compared: of affine matrices' columns three
};

/// Lines that are all the same thing, in words that follow "is".
struct Alike {
    std::string words;
    std::vector<std::size_t> lines;
};

std::optional<std::string> relation_of_line(const Lines& lines, std::size_t line)
{
    const WrongVectors vectors = wrong_vectors(lines.table, lines.wrong, line * lines.side, lines.count);
    if (auto found = relation_of(vectors, lines.table.facts)) return std::move(found->words);
    for (std::size_t other = 0; other < lines.side; ++other) {
        const WrongVectors others = wrong_vectors(lines.table, lines.wrong, other * lines.side, lines.count);
        const auto sign = sign_between(vectors.yours, others.right);
        if (!sign) continue;
        const std::string whose = other == line ? "one" : fmt::format("{} {}", lines.name, other);
        return fmt::format("is the right {}{}", whose, *sign > 0 ? "" : " with the opposite sign");
    }
    return std::nullopt;
}

/// "column 1", "each of columns 0 and 2"
std::string name_of(const Lines& lines, const std::vector<std::size_t>& which)
{
    if (which.size() == 1) return fmt::format("{} {}", lines.name, which.front());
    const auto last = which.end() - 1;
    return fmt::format("each of {}s {} and {}", lines.name, fmt::join(which.begin(), last, ", "), *last);
}

/// What can be said of the lines, and whether that is said of all that differ. Nothing if it is said of less than half.
std::optional<std::pair<std::string, bool>> words_of(const Lines& lines)
{
    std::vector<Alike> found;
    std::size_t told = 0;
    for (const std::size_t line : lines.which) {
        auto relation = relation_of_line(lines, line);
        if (!relation) continue;
        ++told;
        const auto same = std::ranges::find(found, *relation, &Alike::words);
        if (same == found.end())
            found.push_back({*std::move(relation), {line}});
        else
            same->lines.push_back(line);
    }
    if (2 * told <= lines.which.size()) return std::nullopt;
    const bool of_all = told == lines.which.size();
    if (of_all && told == lines.side && found.size() == 1)
        return std::pair(fmt::format("has {}s each of which {}", lines.name, found.front().words), true);
    std::vector<std::string> parts;
    for (const Alike& one : found) parts.push_back(name_of(lines, one.lines) + " " + one.words);
    const std::string_view beginning = told == lines.side ? "is wrong in all {}s: {}"
                                       : of_all           ? "is right but for some {}s: {}"
                                                          : "has several wrong {}s: {}";
    return std::pair(fmt::format(fmt::runtime(beginning), lines.name, fmt::join(parts, ", ")), of_all);
}

std::vector<double> transposed(const std::vector<double>& matrix, std::size_t side)
{
    std::vector<double> other(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) other[i % side * side + i / side] = matrix[i];
    return other;
}

/// Only the wrong ones are transposed; the others stand there for their questions.
AnswerTable transposed(AnswerTable table, std::size_t side)
{
    for (AnswerPair& one : table.answers) {
        if (!one.wrong) continue;
        one.yours = transposed(one.yours, side);
        one.expected = transposed(one.expected, side);
    }
    return table;
}

}

std::vector<AnswerPattern> matrix_line_patterns(const AnswerTable& table, const Pairs& wrong,
                                                const std::vector<std::size_t>& which)
{
    const std::size_t side = table.components == 16 ? 4 : 3;
    if (side * side != table.components || which.size() < 2) return {};
    std::set<std::size_t> columns;
    std::set<std::size_t> rows;
    for (const std::size_t i : which) {
        columns.insert(i / side);
        rows.insert(i % side);
    }
    const auto by_columns = words_of({"column", table, wrong, side, columns, rows.contains(3) ? side : 3});
    if (by_columns && by_columns->second && columns.size() <= rows.size()) return {{by_columns->first}};
    const AnswerTable turned = transposed(table, side);
    Pairs turned_wrong;
    for (const AnswerPair* one : wrong) turned_wrong.push_back(&turned.answers[one - table.answers.data()]);
    const auto by_rows = words_of({"row", turned, turned_wrong, side, rows, side});
    if (by_rows && (by_rows->second || !by_columns)) return {{by_rows->first}};
    if (by_columns) return {{by_columns->first}};
    return {};
}

}
