#include "judge/buffer/buffer_classes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/buffer/buffer_cells.hpp"

namespace umbral::grader {
namespace {

bool is_name(BufferKind kind) { return kind == BufferKind::coverage || kind == BufferKind::ids; }

bool is_background(const BufferCells& cells, std::size_t cell)
{
    return cells.states[cell] == CellState::background || cells.states[cell] == CellState::extra;
}

// Names differ or not; what is measured changes from cell to cell, so that only its coverage has edges.
bool edge_between(const BufferCells& cells, BufferKind kind, std::size_t a, std::size_t b)
{
    if (is_name(kind))
        return !std::ranges::equal(cells.expected.cell(a), cells.expected.cell(b)) ||
               cells.expected.present(a) != cells.expected.present(b);
    return is_background(cells, a) != is_background(cells, b);
}

void add_place(const Check& check, const BufferCells& cells, BufferKind kind, std::size_t cell, BufferClasses& classes)
{
    bool edge = false;
    bool of_neighbour = false;
    for_each_near(cells, cell, [&](std::size_t near) {
        edge = edge || edge_between(cells, kind, cell, near);
        of_neighbour =
            of_neighbour || (near != cell && same_cell(check.tolerance, cells.yours, cell, cells.expected, near));
    });
    classes.at_edge += edge ? 1 : 0;
    classes.neighbour_value += of_neighbour ? 1 : 0;
}

void add_groups(const BufferCells& cells, BufferClasses& classes)
{
    std::vector<bool> seen(cells.states.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start] || !cells.wrong(start)) continue;
        ++classes.groups;
        std::size_t size = 0;
        Box box{cells.columns, cells.rows, 0, 0};
        seen[start] = true;
        open.assign(1, start);
        while (!open.empty()) {
            const std::size_t cell = open.back();
            open.pop_back();
            ++size;
            const std::size_t x = cell % cells.columns;
            const std::size_t y = cell / cells.columns;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
            for_each_near(cells, cell, [&](std::size_t near) {
                if (seen[near] || !cells.wrong(near)) return;
                seen[near] = true;
                open.push_back(near);
            });
        }
        if (size > classes.largest_group) classes.largest_group = size, classes.group = box;
    }
}

// "row 3", "rows 3 to 7", "rows 1, 4, 9, ..."
std::string numbers_text(const char* what, const std::vector<std::size_t>& numbers)
{
    constexpr std::size_t most = 4;
    if (numbers.size() == 1) return fmt::format("{} {}", what, numbers[0]);
    if (numbers.back() - numbers.front() + 1 == numbers.size())
        return fmt::format("{}s {} to {}", what, numbers.front(), numbers.back());
    std::string text = fmt::format("{}s ", what);
    for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
    return text + (numbers.size() > most ? ", ..." : "");
}

// Rows (or columns) in which all content is wrong, if they hold all that is wrong and others are right.
std::string whole_lines(const BufferCells& cells, bool rows)
{
    constexpr std::size_t least_cells = 3;  // a shorter line is a dot
    const std::size_t lines = rows ? cells.rows : cells.columns;
    std::vector<std::size_t> content(lines, 0);
    std::vector<std::size_t> wrong(lines, 0);
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        const std::size_t line = rows ? cell / cells.columns : cell % cells.columns;
        content[line] += cells.states[cell] == CellState::background ? 0 : 1;
        wrong[line] += cells.wrong(cell) ? 1 : 0;
    }
    std::vector<std::size_t> whole;
    bool others_right = false;
    for (std::size_t line = 0; line < lines; ++line) {
        if (wrong[line] == 0) {
            others_right = others_right || content[line] > 0;
            continue;
        }
        if (wrong[line] != content[line] || content[line] < least_cells) return {};
        whole.push_back(line);
    }
    return whole.empty() || !others_right ? std::string() : numbers_text(rows ? "row" : "column", whole);
}

}

BufferKind kind_of(const Tensor& expected, const BufferCells& cells)
{
    const bool measured = is_real(expected.element);
    if (!measured) {
        if (expected.components != 1) return BufferKind::cells;
        const auto values = cells.expected.values();
        const bool two =
            std::all_of(values.begin(), values.end(), [](double value) { return value == 0 || value == 1; });
        return two ? BufferKind::coverage : BufferKind::ids;
    }
    if (expected.components == 1) return BufferKind::depth;
    if (expected.components == 2) return BufferKind::texture;
    if (expected.components != 3) return BufferKind::cells;
    constexpr double unit = 0.01;
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (is_background(cells, cell) || !cells.expected.present(cell)) continue;
        const auto v = cells.expected.cell(cell);
        if (!(std::abs(std::hypot(v[0], v[1], v[2]) - 1) < unit)) return BufferKind::cells;
    }
    return BufferKind::normals;
}

const char* cells_of(BufferKind kind, std::string_view recorded)
{
    switch (kind) {
        case BufferKind::coverage: return "pixels";
        case BufferKind::ids: return recorded.find("id") == std::string_view::npos ? "cells" : "ids";
        case BufferKind::depth: return "depths";
        case BufferKind::normals: return "normals";
        case BufferKind::texture: return "texture coordinates";
        case BufferKind::cells: break;
    }
    return "cells";
}

BufferClasses classify(const Check& check, const BufferCells& cells, BufferKind kind)
{
    BufferClasses classes;
    const std::set<double> known =
        is_name(kind) ? std::set<double>(cells.expected.values().begin(), cells.expected.values().end())
                      : std::set<double>();
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (!cells.wrong(cell)) continue;
        ++classes.wrong;
        add_place(check, cells, kind, cell, classes);
        if (is_name(kind) && cells.yours.present(cell) && !known.contains(cells.yours.cell(cell)[0]))
            ++classes.unknown_value;
    }
    add_groups(cells, classes);
    classes.lines = whole_lines(cells, true);
    if (classes.lines.empty()) classes.lines = whole_lines(cells, false);
    return classes;
}

std::string in_words(const BufferClasses& classes, const BufferPattern& pattern)
{
    if (classes.wrong == 0) return {};
    const auto nearly_all = [&](std::size_t count) {
        return static_cast<double>(count) >= 0.9 * static_cast<double>(classes.wrong);
    };
    const std::string most = classes.wrong == 1                 ? "it lies"
                             : classes.at_edge == classes.wrong ? "all lie"
                                                                : "nearly all lie";
    std::string text = pattern.sentence;
    const auto add = [&text](const std::string& clause) { text += (text.empty() ? "" : "; ") + clause; };
    if (!classes.lines.empty()) add("whole " + classes.lines);
    if (nearly_all(classes.at_edge) && classes.lines.empty() && pattern.sentence.empty())
        add(nearly_all(classes.neighbour_value) ? most + " at an edge and " + (classes.wrong == 1 ? "holds" : "hold") +
                                                      " a neighbour's value: another pixel owns the edge"
                                                : most + " at an edge");
    else if (classes.wrong > 1 && classes.at_edge > 0 && classes.at_edge < classes.wrong && pattern.sentence.empty())
        add(fmt::format("{} at an edge, {} inside", classes.at_edge, classes.wrong - classes.at_edge));
    else if (classes.at_edge == 0 && pattern.sentence.empty() && classes.lines.empty())
        add(classes.wrong == 1 ? "it lies inside, not at an edge" : "all lie inside, none at an edge");
    if (classes.unknown_value > 0)
        add(fmt::format("{} of {} that {} expected nowhere", classes.unknown_value,
                        classes.wrong == 1 ? "a value" : "values", classes.wrong == 1 ? "is" : "are"));
    if (classes.groups > 1 && classes.largest_group > 1)
        add(fmt::format("the largest group has {} in x {}..{}, y {}..{}", classes.largest_group, classes.group.left,
                        classes.group.right, classes.group.top, classes.group.bottom));
    return text;
}

}
