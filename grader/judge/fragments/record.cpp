#include "judge/controls.hpp"
#include "judge/fragments/fragments.hpp"
#include "judge/fragments/rule.hpp"
#include "judge/judge_record.hpp"

namespace umbral::grader {
namespace {

Controls fragment_controls(const Check& check, const Tensor& expected, std::uint64_t seed)
{
    Controls result = common_controls(check, expected, seed);
    if (expected.components < 3) return result;
    if (auto boxes = bounding_boxes(expected, component_statistics(expected).mean))
        result.emplace_back("bounding boxes", std::move(*boxes));
    return result;
}

bool has_places(const Tensor& expected)
{
    return all_finite(to_doubles(expected)) && FragmentTable(expected).unplaced() == 0;
}

Tensor moved_fragments(const Tensor& tensor, const std::array<int, 2>& shift)
{
    std::vector<double> values = to_doubles(tensor);
    for (std::size_t row = 0; row + 3 <= values.size(); row += tensor.components) {
        values[row + 1] += shift[0];
        values[row + 2] += shift[1];
    }
    return with_values(tensor, values);
}

}

extern constinit const JudgeRecord fragments_judge;
constinit const JudgeRecord fragments_judge{
    .name = "fragments",
    .place = 0,
    .compares = "fragments by their pixels",
    .free_rows = true,
    .keys = 3,
    .nothing_is_empty = true,
    .judge = [](const Question& q) { return judge_fragments(q.check, q.student, q.expected, q.names, !q.briefly); },
    .controls = fragment_controls,
    .resemblance = same_fragments,
    .likeness = common_places,
    .evidence = fragments_evidence,
    .relation = {.possible = true, .moves = true, .presentable = has_places, .moved = moved_fragments},
};

}
