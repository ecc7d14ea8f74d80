#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/explain/confidence.hpp"
#include "judge/judge.hpp"

namespace umbral::grader {

/// One check with what is needed to explain why it fails.
struct FailingCheck {
    const Check* check = nullptr;
    const Tensor* student = nullptr;
    const Tensor* expected = nullptr;
    const Tensor* margin = nullptr;
    bool fails = true;  ///< one that the student passes speaks against what would fail it, and for nothing
    /// Share of a row's error that rounding may put between two ways to the same wrong numbers, where a candidate
    /// rounds what the student did not.
    double rounding = 0;
};

/// A named thing that students do to a right result: the explanation holds if undoing it makes the result right.
///
/// `undo` gives the student's tensor with the transform undone, or nothing if the transform does not apply to that
/// shape.
struct NamedTransform {
    std::string name;      ///< "transposed"
    std::string sentence;  ///< "Your matrix is the transpose of the expected one: GLM indexes m[column][row]."
    std::optional<Tensor> (*undo)(const Check& check, const Tensor& student, const Tensor& expected);
    /// The sentence with this result's own figures (a factor, a number of pixels); null where `sentence` says it all.
    std::string (*describe)(const Check& check, const Tensor& student, const Tensor& expected) = nullptr;
    /// What is fitted to the result (a factor, an order, a shift) could have been another: so much less says an
    /// agreement. A fitted transform fits right results too, as no transform at all, so that passing checks say nothing
    /// about it. Negative where values that the transform leaves alone, and that are right, say more than those that it
    /// changes.
    double fitted_bits = 0;
};

/// All named transforms that are tried, in the order of how specific they are.
[[nodiscard]] const std::vector<NamedTransform>& named_transforms();

/// Explanations by named transforms, best first, with their confidence, however small. One is given only if it makes a
/// failing check right (or raises it to at least 0.9 from at most half of that), and if the transform changes the
/// student's result at all. Checks of another recorded value that the student passes say nothing about it: an error may
/// sit in one function of several. Neither do failing checks of another kind, on which it cannot be tried. Since
/// undoing rounds once more, tolerances are widened a little for this, but for no points. No transform fits what
/// has_free_rows.
[[nodiscard]] std::vector<Explanation> explain_by_transform(const std::vector<FailingCheck>& checks);

/// What a check says about the candidate that recorded `mistake`. For it: both deviate from `expected`, and in the same
/// way (within the check's tolerance of the mistake's value for at least 95 % of the rows where either deviates;
/// pictures by the image rule). Nothing: the student passes, and so would the mistake. Against it: all else.
[[nodiscard]] Resemblance resemblance(const FailingCheck& check, const Tensor& mistake);

}
