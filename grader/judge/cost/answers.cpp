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

std::optional<WrongAnswer> first_wrong_answer(const Tensor* student, const Tensor* expected)
{
    if (expected == nullptr) return std::nullopt;
    if (student == nullptr || !well_formed(*student) || student->components != expected->components ||
        student->columns != expected->columns || !student->present.empty())
        return WrongAnswer{0};
    const TensorView yours(*student);
    const TensorView right(*expected);
    for (std::size_t row = 0; row < right.cells(); ++row) {
        if (row >= yours.cells()) return WrongAnswer{row};
        for (std::size_t i = 0; i < right.components(); ++i)
            if (!is_close(yours.cell(row)[i], right.cell(row)[i]))
                return WrongAnswer{row, WrongAnswer::Number{i, yours.cell(row)[i], right.cell(row)[i]}};
    }
    if (yours.cells() > right.cells()) return WrongAnswer{right.cells()};
    return std::nullopt;
}

}
