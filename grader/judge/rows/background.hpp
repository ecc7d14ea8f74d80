#pragma once

#include <cstddef>

#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {

/// Where a picture or a buffer holds its background: the cell whose value is most frequent on the border; of equally
/// frequent ones, the one seen first.
[[nodiscard]] std::size_t background_cell(const Tensor& tensor, const TensorView& view);

}
