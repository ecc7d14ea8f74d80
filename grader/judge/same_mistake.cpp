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

/// What one event, fragment or count that is wrong in the same way says.
constexpr double bits_each = 3;

// Nothing at all is an empty table of the expected shape.
Tensor comparable(const Tensor& tensor, const Tensor& expected)
{
    if (tensor.cells() == 0) {
        Tensor empty = expected;
        empty.rows = 0;
        empty.bytes.clear();
        empty.present.clear();
        return empty;
    }
    return made_finite(tensor);
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

/// A few numbers that agree, each of which says something; one alone if everything is lost, as with code that does nothing.
Resemblance alike(std::size_t agreeing, bool nothing_at_all)
{
    return {Says::for_it, nothing_at_all ? 1 : std::min(bits_each * static_cast<double>(agreeing), thresholds::most_value_bits)};
}

Resemblance same_fragments(const FailingCheck& failing, const Tensor& mistake_tensor)
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
    std::size_t places = 0;
    for_each_of_three(yours, expected, mistake, [&](const Three& here) {
        const bool student_wrong = !against_expected.at_place(here.yours, here.expected).all_right();
        const bool mistake_wrong = !mistake_against_expected.at_place(here.mistake, here.expected).all_right();
        student_deviates = student_deviates || student_wrong;
        mistake_deviates = mistake_deviates || mistake_wrong;
        ++places;
        if (!student_wrong && !mistake_wrong) return;
        ++deviating;
        if (against_mistake.at_place(here.yours, here.mistake).all_right()) ++agreeing;
    });
    if (!student_deviates || !mistake_deviates || static_cast<double>(agreeing) < thresholds::mistake_share * static_cast<double>(deviating))
        return differently;
    Resemblance result = alike(agreeing, failing.student->cells() == 0);
    result.bits += pattern_bits(places, agreeing);
    return result;
}

// What parts two sequences: the elements that an alignment leaves over.
std::size_t apart(const Check& check, const TensorView& a, const TensorView& b) { return a.cells() + b.cells() - 2 * align_events(check, a, b).matches.size(); }

Resemblance same_events(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const TensorView yours(*failing.student);
    const TensorView expected(*failing.expected);
    const TensorView mistake(mistake_tensor);
    const std::size_t student_deviates = apart(*failing.check, yours, expected);
    const std::size_t mistake_deviates = apart(*failing.check, mistake, expected);
    if (student_deviates == 0 || mistake_deviates == 0) return differently;
    const auto largest = static_cast<double>(std::max(student_deviates, mistake_deviates));
    if (static_cast<double>(apart(*failing.check, yours, mistake)) > (1 - thresholds::mistake_share) * largest) return differently;
    return alike(student_deviates, yours.cells() == 0);
}

// Whatever the calls are: the same counts break the same rules for the same reason.
Resemblance same_trace(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const auto yours = parse_gl_trace(text_of(failing.student));
    const auto mistake = parse_gl_trace(text_of(&mistake_tensor));
    const auto expected = parse_gl_trace(text_of(failing.expected));
    if (!yours || !mistake || !expected || fraction_right(*failing.check, *failing.student, *failing.expected, nullptr) >= 1) return differently;
    const auto& rules = failing.check->rules;
    if (!std::ranges::all_of(rules, [&](const std::string& rule) { return counted(*yours, rule) == counted(*mistake, rule); })) return differently;
    // Each count that differs from the expected one is a number that could have been another.
    std::size_t telling = 0;
    for (const std::string& rule : rules) telling += counted(*yours, rule) != counted(*expected, rule) ? 1 : 0;
    return alike(2 * telling, counted(*yours, "draw calls") == 0 && counted(*expected, "draw calls") > 0);
}

Resemblance same_cost(const FailingCheck& failing, const Tensor& mistake)
{
    for (const Tensor* tensor : {failing.student, &mistake})
        if (fraction_right(*failing.check, *tensor, *failing.expected, nullptr) >= 1) return differently;
    const auto a = comparable_growth(*failing.student, *failing.expected);
    const auto b = comparable_growth(mistake, *failing.expected);
    if (a.has_value() != b.has_value() || (a && std::abs(*a - *b) > thresholds::same_growth)) return differently;
    return alike(2, !a);
}

}

Resemblance same_deviations(const FailingCheck& failing, const Tensor& mistake)
{
    switch (failing.check->judge) {
        case JudgeKind::fragments: return same_fragments(failing, mistake);
        case JudgeKind::events: return same_events(failing, mistake);
        case JudgeKind::trace: return same_trace(failing, mistake);
        case JudgeKind::cost: return same_cost(failing, mistake);
        default: return differently;
    }
}

}
