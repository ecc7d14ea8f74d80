#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/judge.hpp"

namespace umbral::grader {

/// What one run recorded for a check with a relation: its own value, the one it follows from, and the one that must
/// differ from that (null where the relation names none). Null also for what was not recorded.
struct RelatedTensors {
    const Tensor* value = nullptr;
    const Tensor* to = nullptr;
    const Tensor* unlike = nullptr;
};

/// The tensor that a value must equal by the check's relation: `to`, scaled and moved. Cells that come in from outside
/// take what `value` has there, so that they agree; nothing is cut off fragments, and the alpha of pictures is not
/// scaled. Nothing if the result is empty or not finite, so that no judge could expect it. Both tensors are well formed
/// and have the shape that the check needs.
[[nodiscard]] std::optional<Tensor> expected_by_relation(const Check& check, const Tensor& to, const Tensor& value);

/// "your own 'upright', moved by (3, 5) pixels".
[[nodiscard]] std::string expected_in_words(const Relation& relation);

/// A control of all values of a relation together: whoever knows nothing writes the same nothing under each name.
struct RelatedControl {
    std::string name;
    Tensor value;
    Tensor to;
    Tensor unlike;  ///< empty where the relation names none

    [[nodiscard]] RelatedTensors tensors() const { return {&value, &to, unlike.cells() > 0 ? &unlike : nullptr}; }
};

/// Judges a check that has a relation: the student's value against the student's own other one, by the rule of the
/// check's judge.
///
/// A constant satisfies most laws, and a run that overwrites its recording can satisfy all of them. So the law counts
/// only
/// - as far as it holds better than where it must not: the value left as it was instead of moved or scaled, and the one
/// that must be
///   unlike, are controls made of the student's own values, which earn nothing; and they must differ at least half as
///   much as the reference's do;
/// - where each of the student's values has something in common with the reference's (likeness.hpp): at least half way
/// from what the best
///   control has to all. A picture that is wrong in the same way everywhere still passes; a blank, a constant, noise,
///   and a fixed picture of something else do not.
class RelationJudge {
public:
    /// `reference` is the reference's run of the case; `margin` as for judge(). These two must outlive the judge, the
    /// check need not. Throws std::invalid_argument where the relation can tell nothing: a value is missing, of another
    /// shape or the same everywhere, or the law holds unmoved as well.
    RelationJudge(const Check& check, const RelatedTensors& reference, const Tensor* margin, std::uint64_t seed);

    RelationJudge(const RelationJudge&) = delete;
    RelationJudge& operator=(const RelationJudge&) = delete;

    /// Never throws for what a student recorded. `names` as for judge().
    [[nodiscard]] Judgement judge(const RelatedTensors& student, const Tensor* names = nullptr) const;
    [[nodiscard]] const std::vector<RelatedControl>& controls() const noexcept { return controls_; }
    [[nodiscard]] BestControl best_control() const;

private:
    struct Side {
        const Tensor* reference;
        double least;  ///< likeness that the student's value needs
        std::string name;
    };
    /// Likeness to the reference's value of a side, where it is compared.
    [[nodiscard]] double alike(std::size_t side, const Tensor& tensor) const;
    /// How well the law holds where it must not: for `to` as it is, and between `unlike` and `to`.
    [[nodiscard]] double unmoved(const RelatedTensors& values) const;
    /// Why the student's values cannot be compared; empty if they can.
    [[nodiscard]] std::string problem(const RelatedTensors& student) const;
    /// Why their agreement would say nothing; empty if it does say something.
    [[nodiscard]] std::string worthless(const RelatedTensors& student, Judgement& judgement) const;

    Check check_;
    const Relation& relation_;  ///< of check_
    const Tensor* margin_;
    std::vector<RelatedControl> controls_;
    std::vector<Side> sides_;  ///< value, to, and unlike where there is one
    double reference_unmoved_ = 0;
};

}
