#include "question/list_patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "question/alike.hpp"

namespace umbral::grader {
namespace {

using RowsOfList = std::span<const double>;

/// So many more rows of each kind than expected; less than 0: fewer. Nothing if a kind is no number.
std::map<double, int> surplus(const AnswerPair& one, std::size_t components)
{
    for (std::size_t at = 0; at < one.yours.size(); at += components)
        if (!std::isfinite(one.yours[at])) return {};
    std::map<double, int> kinds;
    for (std::size_t at = 0; at < one.yours.size(); at += components) ++kinds[one.yours[at]];
    for (std::size_t at = 0; at < one.expected.size(); at += components) --kinds[one.expected[at]];
    std::erase_if(kinds, [](const auto& kind) { return kind.second == 0; });
    return kinds;
}

/// A number, and how large numbers beside it are: less than their rounding is no difference.
struct SizedNumber {
    double number = 0;
    double size = 0;
};

using Rows = std::vector<std::vector<double>>;

/// The rows of a list without their first `keys` numbers.
Rows rows_of(const std::vector<double>& list, std::size_t components, std::size_t keys)
{
    Rows rows;
    for (std::size_t at = 0; at + components <= list.size(); at += components)
        rows.emplace_back(list.begin() + static_cast<std::ptrdiff_t>(at + keys),
                          list.begin() + static_cast<std::ptrdiff_t>(at + components));
    return rows;
}

bool are_alike(const Rows& some, const Rows& others, double size)
{
    return std::ranges::equal(some, others, [size](const auto& a, const auto& b) {
        return std::ranges::equal(a, b, [size](double x, double y) { return alike(x, y, size); });
    });
}

/// Each row where it comes first.
Rows once(const Rows& rows, double size)
{
    Rows result;
    for (const auto& row : rows)
        if (std::ranges::none_of(result, [&](const auto& other) { return are_alike({row}, {other}, size); }))
            result.push_back(row);
    return result;
}

/// What is so of rows that are right, but come too often, not often enough, or elsewhere.
std::vector<std::string> patterns_of_right_rows(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    constexpr std::size_t least_rows = 3;
    constexpr std::size_t most_rows = 300;
    const bool are_places = std::ranges::all_of(
        wrong, [&](const AnswerPair* one) { return keys_are_places(one->expected, table.components, table.keys); });
    const std::size_t keys = are_places ? table.keys : 0;
    bool twice = true;
    bool only_once = true;
    bool turned = true;
    bool in_other_order = true;
    std::size_t long_ones = 0;
    for (const AnswerPair* one : wrong) {
        const Rows yours = rows_of(one->yours, table.components, keys);
        Rows right = rows_of(one->expected, table.components, keys);
        if (std::max(yours.size(), right.size()) > most_rows) return {};
        // Of two rows all that is told here is the same.
        if (right.size() < least_rows) continue;
        ++long_ones;
        double size = 0;
        for (const auto& row : right) size = std::max(size, size_of(row));
        twice = twice && yours.size() > right.size() && are_alike(once(yours, size), once(right, size), size);
        only_once = only_once && yours.size() < right.size() && are_alike(yours, once(right, size), size);
        const bool same_size = yours.size() == right.size();
        bool is_turned = false;
        for (std::size_t i = 0; same_size && turned && i < right.size() && !is_turned; ++i) {
            is_turned = are_alike(yours, right, size);
            std::ranges::rotate(right, right.begin() + 1);
        }
        turned = turned && is_turned;
        Rows sorted = yours;
        std::ranges::sort(sorted);
        std::ranges::sort(right);
        in_other_order = in_other_order && same_size && are_alike(sorted, right, size);
    }
    std::vector<std::string> found;
    if (long_ones < least_wrong) return found;
    if (twice) found.emplace_back("has a row once too often, and the others as they are to be");
    if (only_once) found.emplace_back("has only once what is to come several times");
    if (turned) found.emplace_back("begins with another row, and goes round as it should");
    if (in_other_order && !turned) found.emplace_back("has the right rows in another order");
    return found;
}

/// Is each list of one kind, and not all of the same? Then rows are called as their question is, which says nothing of
/// what is missing.
bool kinds_name_questions(const AnswerTable& table)
{
    std::set<double> different;
    for (const AnswerPair& one : table.answers)
        for (std::size_t at = 0; at < one.expected.size(); at += table.components) {
            if (one.expected[at] != one.expected.front()) return false;
            different.insert(one.expected[at]);
        }
    return different.size() > 1;
}

}

bool keys_are_places(std::span<const double> rows, std::size_t components, std::size_t keys)
{
    for (std::size_t at = 0; at < rows.size(); at += components)
        for (std::size_t key = 0; key < keys; ++key)
            if (rows[at + key] != rows[key] && rows[at + key] != static_cast<double>(at / components)) return false;
    return true;
}

std::vector<std::string> list_patterns(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    std::vector<std::string> found;
    const std::size_t components = table.components;
    // Rows that are so near to each other are alike in any order.
    if (std::ranges::any_of(wrong, [](const AnswerPair* one) {
            return one->yours.size() == one->expected.size() && alike_rows(one->yours, one->expected);
        }))
        return found;
    const auto all = [&](auto holds) {
        return std::ranges::all_of(wrong, [&](const AnswerPair* one) {
            return one->expected.size() > components && holds(RowsOfList(one->yours), RowsOfList(one->expected));
        });
    };
    if (all([&](RowsOfList yours, RowsOfList right) {
            return alike_rows(yours, right.first(right.size() - components));
        }))
        found.emplace_back("lacks the last row");
    if (all([&](RowsOfList yours, RowsOfList right) { return alike_rows(yours, right.subspan(components)); }))
        found.emplace_back("lacks the first row");
    if (all([&](RowsOfList yours, RowsOfList right) {
            return yours.size() == right.size() + components && alike_rows(yours.first(right.size()), right);
        }))
        found.emplace_back("has a row too many at its end");
    if (all([&](RowsOfList yours, RowsOfList right) {
            return yours.size() == right.size() + components && alike_rows(yours.subspan(components), right);
        }))
        found.emplace_back("has a row too many at its beginning");
    if (all([&](RowsOfList yours, RowsOfList right) {
            if (yours.size() != right.size()) return false;
            std::vector<double> turned;
            for (std::size_t at = yours.size(); at > 0; at -= components)
                turned.insert(turned.end(), yours.begin() + static_cast<long>(at - components),
                              yours.begin() + static_cast<long>(at));
            return alike_rows(turned, right);
        }))
        found.emplace_back("has its rows in the opposite order");
    const auto row_by_row = [&](auto make) {
        return all([&](RowsOfList yours, RowsOfList right) {
            constexpr std::size_t least_rows = 3;
            if (yours.size() != right.size() || right.size() < least_rows * components) return false;
            const std::vector<SizedNumber> made = make(right);
            for (std::size_t at = components; at < yours.size(); ++at)
                if (!alike(yours[at], made[at].number, made[at].size)) return false;
            return true;
        });
    };
    if (row_by_row([&](RowsOfList right) {
            std::vector<SizedNumber> sums;
            for (std::size_t at = 0; at < right.size(); ++at) {
                const SizedNumber before = at < components ? SizedNumber() : sums[at - components];
                sums.push_back({before.number + right[at], before.size + std::abs(right[at])});
            }
            return sums;
        }))
        found.emplace_back("has in each row the sum of the right ones up to there");
    if (row_by_row([&](RowsOfList right) {
            const double size = size_of(right);
            std::vector<SizedNumber> late(right.size());
            for (std::size_t at = components; at < right.size(); ++at) late[at] = {right[at - components], size};
            return late;
        }))
        found.emplace_back("has each row one place too late");
    if (!table.picture && table.kinds.empty())
        std::ranges::move(patterns_of_right_rows(table, wrong), std::back_inserter(found));
    return found;
}

std::vector<std::string> kind_patterns(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    // Where all can only be of one kind, that one is missing is seen from their number.
    if (table.kinds.size() < 2 || table.components == 0) return {};
    if (kinds_name_questions(table)) return {};
    std::optional<double> lacking;
    std::optional<double> too_often;
    bool lacks = true;
    bool has = true;
    for (const AnswerPair* one : wrong) {
        const std::map<double, int> kinds = surplus(*one, table.components);
        if (kinds.size() != 1) return {};
        const auto& [kind, more] = *kinds.begin();
        lacks = lacks && more < 0 && (!lacking || *lacking == kind);
        has = has && more > 0 && (!too_often || *too_often == kind);
        (more < 0 ? lacking : too_often) = kind;
    }
    const auto name = [&](const std::optional<double>& kind) {
        const auto found = kind ? table.kinds.find(*kind) : table.kinds.end();
        return found == table.kinds.end() ? std::string() : found->second.name;
    };
    if (lacks && !name(lacking).empty()) return {fmt::format("lacks \"{}\"", name(lacking))};
    if (has && !name(too_often).empty()) return {fmt::format("has \"{}\" too often", name(too_often))};
    return {};
}

}
