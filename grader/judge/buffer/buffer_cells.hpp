#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "judge/rows/tensor_view.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// What became of one cell of a buffer.
enum class CellState : std::uint8_t {
    background,  ///< both sides leave it empty
    right,
    missing,  ///< yours is background
    extra,    ///< only the expected one is background
    other     ///< both hold something, but not the same
};

/// Two buffers of one shape, compared cell by cell.
struct BufferCells {
    TensorView yours;
    TensorView expected;
    std::size_t columns;
    std::size_t rows;
    std::size_t background;  ///< a cell of `expected` that holds the background: the most frequent value of its border
    std::vector<CellState> states;
    double error;  ///< the worst of the cells that can be measured; infinite if one is not finite

    [[nodiscard]] bool wrong(std::size_t cell) const { return states[cell] > CellState::right; }
    [[nodiscard]] std::size_t count(CellState state) const;
};

/// Cells are equal exactly, or within the check's tolerance. Both tensors are well formed, and of one shape.
[[nodiscard]] BufferCells compare_cells(const Check& check, const Tensor& yours, const Tensor& expected);

/// Is the cell of `a` right where the cell of `b` is expected? Infinity equals itself: it is what many clear a depth
/// buffer to. NaN equals nothing.
[[nodiscard]] bool same_cell(const Tolerance& tolerance, const TensorView& a, std::size_t cell_a, const TensorView& b,
                             std::size_t cell_b);

/// Calls `visit` with each cell round this one, itself included, that lies in the buffer.
template <class Visit>
void for_each_near(const BufferCells& cells, std::size_t cell, Visit visit)
{
    const std::size_t x = cell % cells.columns;
    const std::size_t y = cell / cells.columns;
    for (std::size_t near_y = y - std::min<std::size_t>(y, 1); near_y <= std::min(y + 1, cells.rows - 1); ++near_y)
        for (std::size_t near_x = x - std::min<std::size_t>(x, 1); near_x <= std::min(x + 1, cells.columns - 1);
             ++near_x)
            visit(near_y * cells.columns + near_x);
}

/// "pixel (3, 4)"
[[nodiscard]] std::string pixel_text(const BufferCells& cells, std::size_t cell);

}
