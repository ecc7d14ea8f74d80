#include "judge/explain/resemblances.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

/// Lists of three recordings at one place.
struct Three {
    Fragments yours;
    Fragments expected;
    Fragments mistake;
};

/// Calls visit(Three) for every place that one of the three has.
template <class Visit>
void for_each_of_three(const FragmentTable& yours, const FragmentTable& expected, const FragmentTable& mistake,
                       Visit visit)
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

}

Resemblance same_fragments(const FailingCheck& failing, const Tensor& mistake_tensor)
{
    const FragmentTable yours(comparable_table(*failing.student, *failing.expected));
    const FragmentTable expected(*failing.expected);
    const FragmentTable mistake(comparable_table(mistake_tensor, *failing.expected));
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
    if (!student_deviates || !mistake_deviates ||
        static_cast<double>(agreeing) < thresholds::mistake_share * static_cast<double>(deviating))
        return not_alike;
    Resemblance result = alike(agreeing, failing.student->cells() == 0);
    result.bits += pattern_bits(places, agreeing);
    return result;
}

}
