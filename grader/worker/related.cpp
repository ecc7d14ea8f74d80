#include "worker/related.hpp"

#include <fmt/format.h>

#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

Check with_value(const Check& check, const std::string& value)
{
    Check other = check;
    other.value = value;
    other.relation.reset();
    return other;
}

const Tensor* recorded(const Check& check, const RunOutcome& run, const std::string& value)
{
    return value.empty() ? nullptr : observed(with_value(check, value), run);
}

}

RelatedTensors related_tensors(const Check& check, const RunOutcome& run)
{
    return {recorded(check, run, check.value), recorded(check, run, check.relation->to),
            recorded(check, run, check.relation->unlike)};
}

ExpectedSide expected_side(const Check& check, const RunOutcome& student, const RunOutcome& expected)
{
    const Tensor* reference = tensor_of(expected, check.value);
    if (!check.relation) return {std::shared_ptr<const Tensor>(std::shared_ptr<void>(), reference), "reference"};
    const RelatedTensors yours = related_tensors(check, student);
    const bool fits = reference != nullptr && yours.value != nullptr && yours.to != nullptr &&
                      !shape_error(check, *yours.value, *reference) && !shape_error(check, *yours.to, *reference);
    std::optional<Tensor> own;
    if (fits) own = expected_by_relation(check, *yours.to, *yours.value);
    if (!own) return {};
    return {std::make_shared<const Tensor>(std::move(*own)),
            fmt::format("your '{}'{}", check.relation->to,
                        check.relation->moves() || check.relation->scales() ? ", changed" : "")};
}

Check against_reference(const Check& check, const RunOutcome& student, const RunOutcome& expected)
{
    const auto wrong = [&](const Check& plain) {
        const Tensor* yours = observed(plain, student);
        const Expected target = expected_of(plain, expected);
        return yours != nullptr && target.value != nullptr &&
               judge(plain, *yours, *target.value, target.margin).right < 1;
    };
    const Check own = with_value(check, check.value);
    const Check other = with_value(check, check.relation->to);
    return !wrong(own) && wrong(other) ? other : own;
}

}
