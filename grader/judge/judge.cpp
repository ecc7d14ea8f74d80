#include "judge/judge.hpp"

#include <stdexcept>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

Judgement answer(const Question& question)
{
    const Check& check = question.check;
    if (!well_formed(question.expected))
        throw std::invalid_argument("check '" + check.name +
                                    "': the expected recording is damaged: its size does not fit its shape");
    if (question.expected.cells() == 0)
        throw std::invalid_argument("check '" + check.name + "': no row counts: the expected recording is empty");
    const JudgeRecord& judge = judge_of(check);
    if (const auto error = shape_error(check, question.student, question.expected)) {
        Judgement wrong;
        wrong.message = *error;
        return wrong;
    }
    return judge.judge(question);
}

}

std::optional<std::string> shape_error(const Check& check, const Tensor& student, const Tensor& expected)
{
    return judge_of(check).free_rows ? row_shape_error(student, expected) : shape_error(student, expected);
}

Judgement judge(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin,
                const Tensor* names)
{
    return answer({check, student, expected, margin, names});
}

double fraction_right(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin)
{
    return answer({check, student, expected, margin, nullptr, true}).right;
}

}
