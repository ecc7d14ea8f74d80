#include "judge/judges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace umbral::grader {

// Each is defined in its folder, grader/judge/<name>/record.cpp.
extern const JudgeRecord numbers_judge, matrices_judge, buffer_judge, image_judge, fragments_judge, trace_judge,
    events_judge, cost_judge, noise_judge;

std::span<const JudgeRecord* const> judges()
{
    static constexpr std::array all{&matrices_judge, &numbers_judge, &buffer_judge, &image_judge, &fragments_judge,
                                    &trace_judge,    &events_judge,  &cost_judge,   &noise_judge};
    return all;
}

const JudgeRecord* find_judge(std::string_view name)
{
    const auto found = std::ranges::find(judges(), name, [](const JudgeRecord* record) { return record->name; });
    return found == judges().end() ? nullptr : *found;
}

const JudgeRecord& judge_of(const JudgeKind& kind)
{
    if (const JudgeRecord* record = find_judge(kind.name)) return *record;
    throw std::invalid_argument(
        fmt::format("expected one of the judges that the manifest knows, got \"{}\"", kind.name));
}

const JudgeRecord& judge_of(const CheckResult& result)
{
    static constexpr JudgeRecord unknown{};
    const JudgeRecord* record = find_judge(result.kind.name);
    return record == nullptr ? unknown : *record;
}

bool can_be_drawn(const Check& check, const Tensor& tensor)
{
    const JudgeRecord& record = judge_of(check);
    return record.look != Look::none && (record.can_be_drawn == nullptr || record.can_be_drawn(tensor));
}

}
