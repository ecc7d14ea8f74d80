#include "judge/same_mistake.hpp"

#include <cmath>

#include "judge/cost.hpp"
#include "judge/events.hpp"
#include "judge/fragments.hpp"
#include "judge/rules.hpp"
#include "judge/thresholds.hpp"
#include "judge/trace_counts.hpp"

namespace umbral::grader {
namespace {

// Values that are not finite become one that no right answer has, so that two of them agree.
Tensor comparable(const Tensor& tensor, const Tensor& expected)
{
    if (tensor.cells() == 0) {
        Tensor empty = expected;
        empty.rows = 0;
        empty.bytes.clear();
        empty.present.clear();
        return empty;
    }
    std::vector<double> values = to_doubles(tensor);
    for (double& value : values)
        if (!std::isfinite(value)) value = 3e38;
    return with_values(tensor, values);
}

/// Lists of three recordings at one place.
struct Three {
    Fragments yours;
    Fragments expected;
    Fragments mistake;
};

/// Calls visit(Three) for every place that one of the three has.
template <class Visit>
void for_each_of_three(const FragmentTable& yours, const FragmentTable& expected, const FragmentTable& mistake, Visit visit)
{
    std::vector<Three> places;
    std::vector<Fragment> heads;  // one for each place of the first two, to walk beside the third
    for_each_place(yours.sorted(), expected.sorted(), [&](const Place& place, Fragments a, Fragments b) {
        heads.push_back({place, static_cast<std::uint32_t>(places.size())});
        places.push_back({a, b, {}});
    });
    for_each_place(heads, mistake.sorted(), [&](const Place&, Fragments head, Fragments c) {
        Three three = head.empty() ? Three{} : places[head[0].row];
        three.mistake = c;
        visit(three);
    });
}

bool same_fragments(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const FragmentTable yours(comparable(*failing.student, *failing.expected));
    const FragmentTable expected(*failing.expected);
    const FragmentTable mistake(comparable(mistake_tensor, *failing.expected));
    const FragmentMatcher against_expected(*failing.check, yours, expected);
    const FragmentMatcher mistake_against_expected(*failing.check, mistake, expected);
    const FragmentMatcher against_mistake(*failing.check, yours, mistake);
    std::size_t deviating = std::max(yours.unplaced(), mistake.unplaced());
    std::size_t agreeing = std::min(yours.unplaced(), mistake.unplaced());
    bool student_deviates = yours.unplaced() > 0;
    bool mistake_deviates = mistake.unplaced() > 0;
    for_each_of_three(yours, expected, mistake, [&](const Three& here) {
        const bool student_wrong = !against_expected.at_place(here.yours, here.expected).all_right();
        const bool mistake_wrong = !mistake_against_expected.at_place(here.mistake, here.expected).all_right();
        student_deviates = student_deviates || student_wrong;
        mistake_deviates = mistake_deviates || mistake_wrong;
        if (!student_wrong && !mistake_wrong) return;
        ++deviating;
        if (against_mistake.at_place(here.yours, here.mistake).all_right()) ++agreeing;
    });
    return student_deviates && mistake_deviates && static_cast<double>(agreeing) >= thresholds::mistake_share * static_cast<double>(deviating);
}

// What parts two sequences: the elements that an alignment leaves over.
std::size_t apart(const Check& check, const TensorView& a, const TensorView& b) { return a.cells() + b.cells() - 2 * align_events(check, a, b).matches.size(); }

bool same_events(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const TensorView yours(*failing.student);
    const TensorView expected(*failing.expected);
    const TensorView mistake(mistake_tensor);
    const std::size_t student_deviates = apart(*failing.check, yours, expected);
    const std::size_t mistake_deviates = apart(*failing.check, mistake, expected);
    if (student_deviates == 0 || mistake_deviates == 0) return false;
    const auto largest = static_cast<double>(std::max(student_deviates, mistake_deviates));
    return static_cast<double>(apart(*failing.check, yours, mistake)) <= (1 - thresholds::mistake_share) * largest;
}

// Whatever the calls are: the same counts break the same rules for the same reason.
bool same_trace(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const auto yours = parse_gl_trace(text_of(failing.student));
    const auto mistake = parse_gl_trace(text_of(&mistake_tensor));
    if (!yours || !mistake || fraction_right(*failing.check, *failing.student, *failing.expected, nullptr) >= 1) return false;
    return std::ranges::all_of(failing.check->rules, [&](const std::string& rule) { return counted(*yours, rule) == counted(*mistake, rule); });
}

bool same_cost(const FailingCheck& failing, const Tensor& mistake)
{
    for (const Tensor* tensor : {failing.student, &mistake})
        if (fraction_right(*failing.check, *tensor, *failing.expected, nullptr) >= 1) return false;
    const auto a = comparable_growth(*failing.student, *failing.expected);
    const auto b = comparable_growth(mistake, *failing.expected);
    return a && b ? std::abs(*a - *b) <= thresholds::same_growth : !a && !b;
}

}

bool same_deviations(const FailingCheck& failing, const Tensor& mistake)
{
    switch (failing.check->judge) {
        case JudgeKind::fragments: return same_fragments(failing, mistake);
        case JudgeKind::events: return same_events(failing, mistake);
        case JudgeKind::trace: return same_trace(failing, mistake);
        case JudgeKind::cost: return same_cost(failing, mistake);
        default: return false;
    }
}

}
