#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace umbral {

/// A rectangle of cells, stored row by row, top row first, without padding.
///
/// Pictures, depth, id and normal buffers are all grids: they differ in what a cell is.
template <class Cell>
struct Grid {
    int width = 0;
    int height = 0;
    std::vector<Cell> cells;

    Grid() = default;

    /// `width` x `height` cells, all equal to `fill`. Throws std::invalid_argument on a negative size.
    Grid(int columns, int rows, const Cell& fill = {}) : width(columns), height(rows)
    {
        if (columns < 0 || rows < 0)
            throw std::invalid_argument("Grid: expected a size of at least 0 x 0, got " + std::to_string(columns) +
                                        " x " + std::to_string(rows));
        cells.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill);
    }

    /// All cells, row by row, as questions are written; of one, or none, all are equal to it. Throws
    /// std::invalid_argument on a negative size, and if there are more or fewer.
    Grid(int columns, int rows, std::initializer_list<Cell> all)
        : Grid(columns, rows, all.size() == 0 ? Cell{} : *all.begin())
    {
        if (all.size() > 1 && all.size() != cells.size())
            throw std::invalid_argument("Grid: expected " + std::to_string(cells.size()) + " cells, got " +
                                        std::to_string(all.size()));
        if (all.size() > 1) cells = all;
    }

    /// The cell in column x (0 is the left one) and row y (0 is the top one).
    [[nodiscard]] Cell& at(int x, int y) { return cells[index(x, y)]; }
    [[nodiscard]] const Cell& at(int x, int y) const { return cells[index(x, y)]; }

    [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        if (!contains(x, y))
            throw std::out_of_range("Grid: cell (" + std::to_string(x) + ", " + std::to_string(y) + ") is outside " +
                                    std::to_string(width) + " x " + std::to_string(height));
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// An 8-bit sRGB picture with alpha: what files and framebuffers hold.
using Image = Grid<glm::u8vec4>;

}
