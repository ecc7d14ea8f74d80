#include "judge/rows/background.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace umbral::grader {

std::size_t background_cell(const Tensor& tensor, const TensorView& view)
{
    std::map<std::pair<bool, std::vector<double>>, std::size_t> counts;
    std::size_t best = 0;
    std::size_t most = 0;
    for (std::size_t y = 0; y < tensor.rows; ++y)
        for (std::size_t x = 0; x < tensor.columns; ++x) {
            if (y > 0 && y + 1 < tensor.rows && x > 0 && x + 1 < tensor.columns) continue;
            const std::size_t cell = y * tensor.columns + x;
            const auto values = view.cell(cell);
            // NaN has no order; an expected one is nobody's background.
            bool number = true;
            for (const double value : values) number = number && !std::isnan(value);
            if (!number) continue;
            const std::size_t count = ++counts[{view.present(cell), {values.begin(), values.end()}}];
            if (count > most) most = count, best = cell;
        }
    return best;
}

}
