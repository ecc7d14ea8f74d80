#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/judge.hpp"

namespace umbral::grader {

/// One failing check with what is needed to explain it.
struct FailingCheck {
    const Check* check = nullptr;
    const Tensor* student = nullptr;
    const Tensor* expected = nullptr;
    const Tensor* margin = nullptr;
    const Tensor* inputs = nullptr;  ///< reserved for transforms that need the case's inputs; may be null
};

/// A named thing that students do to a right result: the explanation holds if undoing it makes the result right.
///
/// `undo` gives the student's tensor with the transform undone, or nothing if the transform does not apply to that shape.
struct NamedTransform {
    std::string name;      ///< "transposed"
    std::string sentence;  ///< "Your matrix is the transpose of the expected one: GLM indexes m[column][row]."
    std::optional<Tensor> (*undo)(const Check& check, const Tensor& student, const Tensor& expected);
    /// The sentence with this result's own figures (a factor, a number of pixels); null where `sentence` says it all.
    std::string (*describe)(const Check& check, const Tensor& student, const Tensor& expected) = nullptr;
};

/// All named transforms that are tried, in the order of how specific they are.
[[nodiscard]] const std::vector<NamedTransform>& named_transforms();

/// Explanations by named transforms, best first. One is given only if it makes a failing check right (or raises it to at least 0.9
/// from at most half of that), and if the transform changes the student's result at all; `confidence` is the share of the failing checks.
/// Since undoing rounds once more, tolerances are widened a little for this, but for no points. No transform fits what has_free_rows.
[[nodiscard]] std::vector<Explanation> explain_by_transform(const std::vector<FailingCheck>& failing);

/// How well one recorded tensor matches a mistake's: both must deviate from `expected`, and in the same way (within the check's
/// tolerance of the mistake's value for at least 95 % of the rows where either deviates; pictures by the image rule). True if so.
[[nodiscard]] bool matches_mistake(const FailingCheck& failing, const Tensor& mistake);

}
