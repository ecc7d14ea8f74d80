#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "judge/explain/transforms.hpp"
#include "judge/judges.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

using Result = std::optional<Tensor>;
using Entries = std::span<double>;
using Target = std::span<const double>;

std::size_t side_of(std::span<const double> entries) { return entries.size() == 9 ? 3 : 4; }

bool is_matrices(const Check& check, const Tensor& tensor)
{
    return judge_of(check).rows == matrix_rows && (tensor.components == 9 || tensor.components == 16);
}

template <void (*change)(Entries, Target), std::uint32_t components = 0>
Result each_matrix(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_matrices(check, student) || (components != 0 && student.components != components)) return std::nullopt;
    return map_cells(student, expected, change);
}

double& entry(Entries m, std::size_t row, std::size_t column) { return m[column * side_of(m) + row]; }
double entry(Target m, std::size_t row, std::size_t column) { return m[column * side_of(m) + row]; }

void transpose_block(Entries m, std::size_t side)
{
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = i + 1; j < side; ++j) std::swap(entry(m, i, j), entry(m, j, i));
}

void transpose(Entries m, Target) { transpose_block(m, side_of(m)); }
void transpose_rotation(Entries m, Target) { transpose_block(m, 3); }

template <class Matrix>
void invert_as(Entries m)
{
    Matrix matrix;
    std::copy(m.begin(), m.end(), &matrix[0][0]);
    matrix = glm::inverse(matrix);
    std::copy_n(&matrix[0][0], m.size(), m.begin());
}

// A singular matrix gives entries that are not finite, which nothing accepts.
void invert(Entries m, Target)
{
    if (m.size() == 9)
        invert_as<glm::dmat3>(m);
    else
        invert_as<glm::dmat4>(m);
}

std::array<double, 3> translation_of(Target m) { return {entry(m, 0, 3), entry(m, 1, 3), entry(m, 2, 3)}; }

void negate_translation(Entries m, Target)
{
    for (std::size_t i = 0; i < 3; ++i) entry(m, i, 3) = -entry(m, i, 3);
}

// A translation of -eye (or eye) that the rotation was not applied to; the sign that fits is taken.
void rotate_translation(Entries m, Target target)
{
    const auto t = translation_of(m);
    std::array<double, 3> rotated{};
    double plus = 0;
    double minus = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) rotated[i] += entry(m, i, j) * t[j];
        plus += std::abs(rotated[i] - entry(target, i, 3));
        minus += std::abs(rotated[i] + entry(target, i, 3));
    }
    for (std::size_t i = 0; i < 3; ++i) entry(m, i, 3) = plus <= minus ? rotated[i] : -rotated[i];
}

void restore_translation(Entries m, Target target)
{
    const auto t = translation_of(m);
    if (t[0] != 0 || t[1] != 0 || t[2] != 0) return;
    for (std::size_t i = 0; i < 3; ++i) entry(m, i, 3) = entry(target, i, 3);
}

void restore_homogeneous_row(Entries m, Target target)
{
    for (std::size_t j = 0; j < 4; ++j) entry(m, 3, j) = entry(target, 3, j);
}

// One axis of the target space (a row) or of the source space (a column) points the other way.
struct Flip {
    bool row = true;
    std::size_t axis = 0;
    Tensor tensor;
};

std::optional<Flip> best_flip(const Check& check, const Tensor& student, const Tensor& expected)
{
    if (!is_matrices(check, student)) return std::nullopt;
    std::optional<Flip> best;
    double nearest = 0;
    for (const bool row : {true, false})
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Tensor candidate = map_cells(student, expected, [&](Entries m, Target) {
                for (std::size_t i = 0; i < side_of(m); ++i) {
                    double& value = row ? entry(m, axis, i) : entry(m, i, axis);
                    value = -value;
                }
            });
            const double apart = distance(candidate, expected);
            if (!best || apart < nearest) nearest = apart, best = Flip{row, axis, std::move(candidate)};
        }
    return best;
}

Result unflip(const Check& check, const Tensor& student, const Tensor& expected)
{
    auto best = best_flip(check, student, expected);
    if (!best) return std::nullopt;
    return std::move(best->tensor);
}

std::string describe_flip(const Check& check, const Tensor& student, const Tensor& expected)
{
    const auto best = best_flip(check, student, expected);
    if (!best) return {};
    return fmt::format(
        "The {} axis of your matrix ({} {}) points the other way: check its sign, and whether the frame is "
        "right-handed.",
        "xyz"[best->axis], best -> row ? "row" : "column", best->axis);
}

/// Do the first three rows and columns turn only: are they of length 1 and perpendicular?
bool turns_only(Target m)
{
    constexpr double tolerance = 1e-3;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) {
            double product = 0;
            for (std::size_t k = 0; k < 3; ++k) product += entry(m, i, k) * entry(m, j, k);
            if (std::abs(product - (i == j ? 1 : 0)) > tolerance) return false;
        }
    return true;
}

/// Of a camera only where it may be one.
std::string describe_bare_place(const Check&, const Tensor&, const Tensor& expected)
{
    const TensorView matrices(expected);
    bool only_turns = true;
    for (std::size_t i = 0; i < matrices.cells(); ++i)
        only_turns = only_turns && (!matrices.present(i) || turns_only(matrices.cell(i)));
    if (!only_turns) return {};
    return "Your translation is the position itself: it must be rotated too, as in a camera's matrix, -R * eye instead "
           "of -eye.";
}

// The rotation about the expected axis by `factor` times the expected angle (or by that angle less a full turn), if
// there is an axis to see.
bool turned_by_factor(Target yours, Target target, double factor)
{
    glm::dmat3 rotation;
    glm::dmat3 found;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const auto column = static_cast<glm::length_t>(j);
            const auto row = static_cast<glm::length_t>(i);
            rotation[column][row] = entry(target, i, j);
            found[column][row] = entry(yours, i, j);
        }
    const glm::dvec3 twice_axis(rotation[1][2] - rotation[2][1], rotation[2][0] - rotation[0][2],
                                rotation[0][1] - rotation[1][0]);
    const double size = glm::length(twice_axis);
    if (!(size > 1e-3)) return false;
    const double angle = std::atan2(size, rotation[0][0] + rotation[1][1] + rotation[2][2] - 1);
    // Angles about one axis repeat every turn, their multiples do not: try the turns that people write.
    for (int turn = -2; turn <= 2; ++turn) {
        const glm::dmat3 wrong(
            glm::rotate(glm::dmat4(1), factor * (angle + 2 * std::numbers::pi * turn), twice_axis / size));
        double apart = 0;
        for (glm::length_t c = 0; c < 3; ++c) apart = std::max(apart, glm::length(wrong[c] - found[c]));
        if (apart < 2e-3) return true;
    }
    return false;
}

bool opened_by_factor(Target yours, Target target, double factor)
{
    if (target.size() != 16 || entry(target, 1, 1) <= 0 || entry(target, 3, 3) != 0) return false;
    const double field = 2 * std::atan(1 / entry(target, 1, 1));
    const double wrong = 1 / std::tan(factor * field / 2);
    return std::abs(entry(yours, 1, 1) - wrong) < 2e-3 * std::abs(wrong);
}

// What an angle in the wrong unit gives cannot be undone, so the expected parts replace it where exactly that is found.
void repair_angle(Entries m, Target target)
{
    for (const double factor : {std::numbers::pi / 180, 180 / std::numbers::pi}) {
        if (turned_by_factor(m, target, factor)) {
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) entry(m, i, j) = entry(target, i, j);
            return;
        }
        if (opened_by_factor(m, target, factor)) {
            for (std::size_t i = 0; i < 2; ++i) entry(m, i, i) = entry(target, i, i);
            return;
        }
    }
}

}

std::vector<NamedTransform> matrix_transforms()
{
    return {
        {"transposed", "Your matrix is the transpose of the expected one: GLM indexes m[column][row].",
         each_matrix<transpose>},
        {"inverse",
         "Your matrix is the inverse of the expected one: it maps the other way, as camera to world instead of world "
         "to camera.",
         each_matrix<invert>},
        {"rotation transposed",
         "Your axes stand in the columns where they belong in the rows (or the other way round); the translation is "
         "right.",
         each_matrix<transpose_rotation, 16>},
        {"translation missing", "Your matrix turns but does not move: its translation is zero.",
         each_matrix<restore_translation, 16>},
        {"translation negated",
         "Your translation has the opposite sign: what moves points moves the axes the other way.",
         each_matrix<negate_translation, 16>},
        {"translation not rotated",
         "The last column of your matrix is the place itself: the matrix beside it must be applied to it too, A * p "
         "(or "
         "-A * p) instead of p.",
         each_matrix<rotate_translation, 16>, describe_bare_place},
        {"homogeneous row", "All is right but the last row, which makes the homogeneous coordinate w.",
         each_matrix<restore_homogeneous_row, 16>},
        {"axis flipped", "One axis of your matrix points the other way: check the handedness.", unflip, describe_flip,
         3},
        {"angle in degrees",
         "Your angle was taken in the wrong unit: sin, cos, tan and GLM want radians (glm::radians converts).",
         each_matrix<repair_angle>},
    };
}

}
