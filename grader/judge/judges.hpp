#pragma once

#include <span>
#include <string_view>

#include "judge/judge_record.hpp"

namespace umbral::grader {

/// All judges, in the order in which messages list them and transforms are tried: matrices before numbers, of which
/// less can be said.
[[nodiscard]] std::span<const JudgeRecord* const> judges();

/// The judge of that name, or null.
[[nodiscard]] const JudgeRecord* find_judge(std::string_view name);

/// The judge of a check. Throws std::invalid_argument if there is none of that name.
[[nodiscard]] const JudgeRecord& judge_of(const JudgeKind& kind);
[[nodiscard]] inline const JudgeRecord& judge_of(const Check& check) { return judge_of(check.judge); }

/// The judge of a result, which may come from a file of another version: what is not known is shown like what is
/// counted or derived.
[[nodiscard]] const JudgeRecord& judge_of(const CheckResult& result);

/// Does the judge look at colours or light, of which a check may say the range?
[[nodiscard]] constexpr bool has_range(const JudgeRecord& record)
{
    return record.look == Look::colours || record.look == Look::light;
}

/// Is what the check looks at a picture or a buffer?
[[nodiscard]] inline bool is_by_chance(const Check& check) { return judge_of(check).judge_both != nullptr; }
[[nodiscard]] inline bool is_picture(const Check& check) { return judge_of(check).look != Look::none; }
/// … and this value of it one that can be drawn?
[[nodiscard]] bool can_be_drawn(const Check& check, const Tensor& tensor);

}
