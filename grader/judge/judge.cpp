#include "judge/judge.hpp"

#include <stdexcept>

#include "judge/rules.hpp"
#include "judge/tensor_view.hpp"

namespace umbral::grader {
namespace {

/// How much is asked of a judge beside the fraction that is right.
enum class Detail { fraction, all };

Judgement dispatch(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin, const Tensor* names, Detail detail)
{
    if (!well_formed(expected)) throw std::invalid_argument("check '" + check.name + "': the expected recording is damaged: its size does not fit its shape");
    if (expected.cells() == 0) throw std::invalid_argument("check '" + check.name + "': no row counts: the expected recording is empty");
    if (const auto error = shape_error(check, student, expected)) {
        Judgement wrong;
        wrong.message = *error;
        return wrong;
    }
    const bool all = detail == Detail::all;
    switch (check.judge) {
        case JudgeKind::numbers: return judge_numbers(check, student, expected, margin);
        case JudgeKind::matrices: return judge_matrices(check, student, expected, margin);
        case JudgeKind::buffer: return judge_buffer(check, student, expected, all);
        case JudgeKind::image: return judge_image(check, student, expected, all);
        case JudgeKind::fragments: return judge_fragments(check, student, expected, names, all);
        case JudgeKind::events: return judge_events(check, student, expected, names);
        case JudgeKind::trace: return judge_trace(check, student, expected);
        case JudgeKind::cost: return judge_cost(check, student, expected, names);
        case JudgeKind::noise: return judge_noise(check, student, expected, names);
    }
    throw std::invalid_argument("check '" + check.name + "': expected one of the judges that the manifest knows");
}

}

bool has_free_rows(JudgeKind kind) { return kind == JudgeKind::fragments || kind == JudgeKind::trace || kind == JudgeKind::events || kind == JudgeKind::cost; }

std::optional<std::string> shape_error(const Check& check, const Tensor& student, const Tensor& expected)
{
    return has_free_rows(check.judge) ? row_shape_error(student, expected) : shape_error(student, expected);
}

Judgement judge(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin, const Tensor* names)
{
    return dispatch(check, student, expected, margin, names, Detail::all);
}

double fraction_right(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin)
{
    return dispatch(check, student, expected, margin, nullptr, Detail::fraction).right;
}

}
