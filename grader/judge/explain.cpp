#include "judge/explain.hpp"

#include <algorithm>
#include <cmath>

#include "judge/rows.hpp"
#include "judge/rules.hpp"
#include "judge/same_mistake.hpp"
#include "judge/tensor_view.hpp"
#include "judge/thresholds.hpp"
#include "judge/transforms.hpp"

namespace umbral::grader {
namespace {

bool comparable(const FailingCheck& failing)
{
    return failing.check != nullptr && failing.student != nullptr && failing.expected != nullptr && well_formed(*failing.expected) &&
           failing.expected->cells() > 0 && !shape_error(*failing.check, *failing.student, *failing.expected);
}

// Undoing rounds again, so bounds are widened to what a few float operations lose; the result as it came must fail these too.
Check widened(Check check)
{
    Tolerance& tolerance = check.tolerance;
    if (has_bound(tolerance)) tolerance.relative = std::max(4 * tolerance.relative.value_or(0), 1e-5);
    if (tolerance.absolute) tolerance.absolute = 4 * *tolerance.absolute;
    if (tolerance.ulps) tolerance.ulps = 4 * *tolerance.ulps;
    if (check.judge == JudgeKind::buffer && !has_bound(tolerance)) tolerance.relative = 1e-5;
    return check;
}

bool explains(const NamedTransform& transform, const Check& check, const FailingCheck& failing, double before)
{
    const auto undone = transform.undo(check, *failing.student, *failing.expected);
    if (!undone || *undone == *failing.student) return false;
    const double after = fraction_right(check, *undone, *failing.expected, failing.margin);
    return after >= check.full || (after >= thresholds::explained && before <= thresholds::unexplained_share * after);
}

}

const std::vector<NamedTransform>& named_transforms()
{
    static const std::vector<NamedTransform> all = [] {
        std::vector<NamedTransform> list = matrix_transforms();
        for (auto make : {number_transforms, image_transforms})
            for (NamedTransform& transform : make()) list.push_back(std::move(transform));
        return list;
    }();
    return all;
}

std::vector<Explanation> explain_by_transform(const std::vector<FailingCheck>& failing)
{
    std::vector<Explanation> explanations;
    for (const NamedTransform& transform : named_transforms()) explanations.push_back({transform.name, transform.sentence, 0});
    for (const FailingCheck& one : failing) {
        if (!comparable(one) || has_free_rows(one.check->judge)) continue;
        const Check check = widened(*one.check);
        const double before = fraction_right(check, *one.student, *one.expected, one.margin);
        if (before >= check.full) continue;
        for (std::size_t i = 0; i < explanations.size(); ++i) {
            const NamedTransform& transform = named_transforms()[i];
            if (!explains(transform, check, one, before)) continue;
            if (explanations[i].confidence == 0 && transform.describe != nullptr)
                if (std::string sentence = transform.describe(check, *one.student, *one.expected); !sentence.empty())
                    explanations[i].sentence = std::move(sentence);
            explanations[i].confidence += 1.0 / static_cast<double>(failing.size());
        }
    }
    std::erase_if(explanations, [](const Explanation& explanation) { return explanation.confidence == 0; });
    std::stable_sort(explanations.begin(), explanations.end(), [](const Explanation& a, const Explanation& b) { return a.confidence > b.confidence + 1e-9; });
    for (Explanation& explanation : explanations) explanation.confidence = std::min(explanation.confidence, 1.0);
    return explanations;
}

namespace {

// Two results that are both not finite went wrong in the same way: give them one value that no right answer has.
Tensor without_infinities(const Tensor& tensor)
{
    std::vector<double> values = to_doubles(tensor);
    for (double& value : values)
        if (!std::isfinite(value)) value = 3e38;
    return with_values(tensor, values);
}

bool same_rows(Check check, const FailingCheck& failing, const Tensor& mistake_tensor)
{
    check.pairs = false;
    if (!has_bound(check.tolerance)) check.tolerance.absolute = 0;
    const RowKind& kind = check.judge == JudgeKind::matrices ? matrix_rows() : number_rows();
    const Tensor student = without_infinities(*failing.student);
    const Tensor expected = without_infinities(*failing.expected);
    const Tensor mistake = without_infinities(mistake_tensor);
    const auto student_states = row_states(check, student, expected, failing.margin, kind);
    const auto mistake_states = row_states(check, mistake, expected, failing.margin, kind);
    const auto agreement = row_states(check, student, mistake, failing.margin, kind);
    std::size_t deviating = 0;
    std::size_t agreeing = 0;
    bool student_deviates = false;
    bool mistake_deviates = false;
    for (std::size_t i = 0; i < agreement.size(); ++i) {
        const bool yours = student_states[i] == RowState::wrong;
        const bool its = mistake_states[i] == RowState::wrong;
        student_deviates = student_deviates || yours;
        mistake_deviates = mistake_deviates || its;
        if (!yours && !its) continue;
        ++deviating;
        if (agreement[i] == RowState::right) ++agreeing;
    }
    return student_deviates && mistake_deviates && static_cast<double>(agreeing) >= thresholds::mistake_share * static_cast<double>(deviating);
}

bool same_picture(const Check& check, const FailingCheck& failing, const Tensor& mistake)
{
    if (fraction_right(check, *failing.student, *failing.expected, nullptr) >= 1 || fraction_right(check, mistake, *failing.expected, nullptr) >= 1)
        return false;
    if (*failing.student == mistake) return true;
    // A mistake's picture that is not finite is no picture to compare with.
    const auto finite = [](const Tensor& tensor) { return all_finite(to_doubles(tensor)); };
    return finite(mistake) && fraction_right(check, *failing.student, mistake, nullptr) >= 1;
}

}

bool matches_mistake(const FailingCheck& failing, const Tensor& mistake)
{
    if (!comparable(failing) || shape_error(*failing.check, mistake, *failing.expected)) return false;
    if (has_free_rows(failing.check->judge)) return same_deviations(failing, mistake);
    if (failing.check->judge == JudgeKind::image || failing.check->judge == JudgeKind::noise) return same_picture(*failing.check, failing, mistake);
    return same_rows(*failing.check, failing, mistake);
}

}
