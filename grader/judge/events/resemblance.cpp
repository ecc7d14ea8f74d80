#include "judge/events/events.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/explain/thresholds.hpp"

namespace umbral::grader {
namespace {

// What parts two sequences: the elements that an alignment leaves over.
std::size_t apart(const Check& check, const TensorView& a, const TensorView& b)
{
    return a.cells() + b.cells() - 2 * align_events(check, a, b).matches.size();
}

}

Resemblance same_events(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const TensorView yours(*failing.student);
    const TensorView expected(*failing.expected);
    const TensorView mistake(mistake_tensor);
    const std::size_t student_deviates = apart(*failing.check, yours, expected);
    const std::size_t mistake_deviates = apart(*failing.check, mistake, expected);
    if (student_deviates == 0 || mistake_deviates == 0) return not_alike;
    const auto largest = static_cast<double>(std::max(student_deviates, mistake_deviates));
    if (static_cast<double>(apart(*failing.check, yours, mistake)) > (1 - thresholds::mistake_share) * largest)
        return not_alike;
    return alike(student_deviates, yours.cells() == 0);
}

}
