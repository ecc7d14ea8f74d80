#include "judge/cost/answers.hpp"

#include <cmath>

#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

bool is_close(double number, double expected)
{
    return std::abs(number - expected) <= answer_tolerance * (1 + std::abs(expected));
}

}

std::optional<std::size_t> first_wrong_answer(const Tensor* student, const Tensor* expected)
{
    if (expected == nullptr) return std::nullopt;
    if (student == nullptr || !well_formed(*student) || student->components != expected->components ||
        student->columns != expected->columns || !student->present.empty())
        return 0;
    const TensorView yours(*student);
    const TensorView right(*expected);
    for (std::size_t row = 0; row < right.cells(); ++row) {
        if (row >= yours.cells()) return row;
        for (std::size_t i = 0; i < right.components(); ++i)
            if (!is_close(yours.cell(row)[i], right.cell(row)[i])) return row;
    }
    if (yours.cells() > right.cells()) return right.cells();
    return std::nullopt;
}

}
