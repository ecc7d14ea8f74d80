#include "judge/picture/image_windows.hpp"

#include <algorithm>
#include <cmath>

#include "judge/explain/thresholds.hpp"

namespace umbral::grader {
namespace {

constexpr int cell_side = window_side / 2;

/// Sums over cells of cell_side x cell_side pixels, row by row; a window is two by two of them.
struct CellSums {
    int columns;
    int rows;
    std::vector<int> sums;

    CellSums(int width, int height)
        : columns((width + cell_side - 1) / cell_side),
          rows((height + cell_side - 1) / cell_side),
          sums(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0)
    {
    }
    [[nodiscard]] int* row(int y)
    {
        return sums.data() + static_cast<std::size_t>(y / cell_side) * static_cast<std::size_t>(columns);
    }
    [[nodiscard]] int at(int x, int y) const
    {
        return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] int window(int x, int y) const
    {
        const int right = std::min(x + 1, columns - 1);
        const int bottom = std::min(y + 1, rows - 1);
        const int top = at(x, y) + (right > x ? at(right, y) : 0);
        return top + (bottom > y ? at(x, bottom) + (right > x ? at(right, bottom) : 0) : 0);
    }
};

// Adds value(x) of a row to the cells that it crosses; whole cells have a fixed length, which compilers turn into
// vector code.
template <class Value>
void add_row(int* cells, int width, Value value)
{
    const int whole = width / cell_side;
    for (int i = 0; i < whole; ++i) {
        int sum = 0;
        for (int x = 0; x < cell_side; ++x) sum += value(i * cell_side + x);
        cells[i] += sum;
    }
    for (int x = whole * cell_side; x < width; ++x) cells[whole] += value(x);
}

template <class Visit>
void for_each_window(const CellSums& cells, Visit visit)
{
    for (int y = 0; y < std::max(1, cells.rows - 1); ++y)
        for (int x = 0; x < std::max(1, cells.columns - 1); ++x) visit(x, y);
}

}

DensestWindow densest_window(const std::vector<std::uint8_t>& marks, int width, int height)
{
    CellSums cells(width, height);
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* row = marks.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        add_row(cells.row(y), width, [row](int x) { return int{row[x]}; });
    }
    DensestWindow densest;
    for_each_window(cells, [&](int x, int y) {
        if (const int count = cells.window(x, y); count > densest.count)
            densest = {count, x * cell_side, y * cell_side};
    });
    return densest;
}

LevelWindow worst_level_window(const Picture& student, const Picture& expected, const std::vector<std::uint8_t>& mask)
{
    LevelWindow worst;
    CellSums counts(expected.width, expected.height);
    const auto mask_row = [&](int y) {
        return mask.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width);
    };
    for (int y = 0; y < expected.height; ++y)
        add_row(counts.row(y), expected.width, [row = mask_row(y)](int x) { return int{row[x]}; });
    // Of few windows the level matters: of those that may be worse than the worst so far.
    const auto level_at = [&](int c, int left, int top, int count) {
        int sum = 0;
        for (int y = top; y < std::min(expected.height, top + window_side); ++y)
            for (int x = left; x < std::min(expected.width, left + window_side); ++x)
                sum += expected.row(c, y)[x] * mask_row(y)[x];
        return static_cast<double>(sum) / count;
    };
    for (int c = 0; c < expected.colours(); ++c) {
        CellSums differences(expected.width, expected.height);
        for (int y = 0; y < expected.height; ++y) {
            const std::uint8_t* yours = student.row(c, y);
            const std::uint8_t* target = expected.row(c, y);
            add_row(differences.row(y), expected.width,
                    [=, inside = mask_row(y)](int x) { return (yours[x] - target[x]) * inside[x]; });
        }
        for_each_window(counts, [&](int x, int y) {
            const int count = counts.window(x, y);
            if (count < thresholds::window_pixels) return;
            const double difference = static_cast<double>(differences.window(x, y)) / count;
            if (std::abs(difference) <= worst.ratio * thresholds::window_levels) return;
            const double level = level_at(c, x * cell_side, y * cell_side, count);
            const double ratio =
                std::abs(difference) / std::max(thresholds::window_levels, thresholds::window_share * level);
            if (ratio > worst.ratio) worst = {difference, level, ratio, x * cell_side, y * cell_side};
        });
    }
    return worst;
}

}
