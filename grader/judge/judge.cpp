#include "judge/judge.hpp"

#include <stdexcept>

#include "judge/rules.hpp"
#include "judge/tensor_view.hpp"

namespace umbral::grader {
namespace {

Judgement dispatch(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin, bool with_metrics)
{
    if (!well_formed(expected)) throw std::invalid_argument("check '" + check.name + "': the expected recording is damaged: its size does not fit its shape");
    if (expected.cells() == 0) throw std::invalid_argument("check '" + check.name + "': no row counts: the expected recording is empty");
    if (const auto error = shape_error(student, expected)) {
        Judgement wrong;
        wrong.message = *error;
        return wrong;
    }
    switch (check.judge) {
        case JudgeKind::numbers: return judge_numbers(check, student, expected, margin);
        case JudgeKind::matrices: return judge_matrices(check, student, expected, margin);
        case JudgeKind::buffer: return judge_buffer(check, student, expected);
        case JudgeKind::image: return judge_image(check, student, expected, with_metrics);
        case JudgeKind::fragments:
        case JudgeKind::trace:
        case JudgeKind::events:
        case JudgeKind::cost: break;
    }
    throw std::invalid_argument("check '" + check.name + "': expected the judge numbers, matrices, buffer or image");
}

}

Judgement judge(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin)
{
    return dispatch(check, student, expected, margin, true);
}

double fraction_right(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin)
{
    return dispatch(check, student, expected, margin, false).right;
}

}
