#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/paint.hpp"

namespace umbral::grader {

using MatrixText = std::vector<std::vector<std::string>>;

/// The matrix written "[a b; c d]" within a judge's text, entries as they are written; nothing if there is none or rows
/// differ in length.
[[nodiscard]] std::optional<MatrixText> find_matrix(std::string_view text);

/// Which entries differ noticeably: by more than a hundredth of the largest difference, or where one of the two is no
/// finite number. Both matrices have the same shape.
[[nodiscard]] std::vector<std::vector<bool>> differing_entries(const MatrixText& yours, const MatrixText& expected);

/// The student's value and the expected one beside each other, matrices as matrices with differing entries marked (by a
/// sign, not by colour alone), one below the other where they do not fit into `width` cells.
[[nodiscard]] std::vector<std::string> side_by_side(const Difference& difference, int width, const Paint& paint);

}
