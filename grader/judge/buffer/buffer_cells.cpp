#include "judge/buffer/buffer_cells.hpp"

#include <algorithm>
#include <cmath>

#include "judge/rows/background.hpp"
#include "judge/rows/tolerance.hpp"

namespace umbral::grader {
namespace {

struct CellMatch {
    bool equal = true;
    bool comparable = true;
    double error = 0;
};

CellMatch match(const Tolerance& tolerance, const TensorView& a, std::size_t cell_a, const TensorView& b,
                std::size_t cell_b)
{
    if (!a.present(cell_a) || !b.present(cell_b)) return {a.present(cell_a) == b.present(cell_b), false, 0};
    CellMatch result;
    for (std::size_t i = 0; i < b.components(); ++i) {
        const double yours = a.cell(cell_a)[i];
        const double expected = b.cell(cell_b)[i];
        if (yours == expected) continue;
        const Deviation found = deviation(tolerance, yours, expected, {float_ulp(expected), std::abs(expected)});
        result.equal = result.equal && found.right && std::isfinite(expected);
        if (!found.right || found.within) result.error = std::max(result.error, found.error);
    }
    return result;
}

}

std::size_t BufferCells::count(CellState state) const
{
    return static_cast<std::size_t>(std::count(states.begin(), states.end(), state));
}

bool same_cell(const Tolerance& tolerance, const TensorView& a, std::size_t cell_a, const TensorView& b,
               std::size_t cell_b)
{
    return match(tolerance, a, cell_a, b, cell_b).equal;
}

BufferCells compare_cells(const Check& check, const Tensor& yours, const Tensor& expected)
{
    BufferCells cells{TensorView(yours), TensorView(expected), expected.columns, expected.rows, 0, {}, 0};
    cells.background = background_cell(expected, cells.expected);
    cells.states.assign(cells.expected.cells(), CellState::background);
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        const CellMatch found = match(check.tolerance, cells.yours, cell, cells.expected, cell);
        const bool expected_background =
            same_cell(check.tolerance, cells.expected, cell, cells.expected, cells.background);
        const bool yours_background = same_cell(check.tolerance, cells.yours, cell, cells.expected, cells.background);
        if (expected_background && yours_background && found.equal) continue;
        if (found.comparable) cells.error = std::max(cells.error, found.error);
        cells.states[cell] = found.equal           ? CellState::right
                             : expected_background ? CellState::extra
                             : yours_background    ? CellState::missing
                                                   : CellState::other;
    }
    return cells;
}

std::string pixel_text(const BufferCells& cells, std::size_t cell)
{
    return "pixel (" + std::to_string(cell % cells.columns) + ", " + std::to_string(cell / cells.columns) + ")";
}

}
