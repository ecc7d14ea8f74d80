#include "validate/known_questions.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "judge/judges.hpp"
#include "judge/rows/tensor_view.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

/// Seeds of which a table has the answers: inputs that are drawn from fewer values than these are known.
constexpr unsigned written_down = 8;

/// A question, which of its rows one is, and what that holds.
using KnownRow = std::tuple<std::string, std::vector<std::uint64_t>, std::size_t, std::vector<std::uint64_t>>;

/// As they are, so that NaN is equal to itself.
std::vector<std::uint64_t> bits_of(std::span<const double> numbers)
{
    std::vector<std::uint64_t> bits;
    for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
    return bits;
}

/// Calls `take` with each row that is an answer to a call; returns how many rows there are.
std::size_t visit_rows(Worker& worker, const Exercise& exercise, const Check& check, std::uint64_t seed,
                       const std::function<void(KnownRow)>& take)
{
    const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, seed);
    const Tensor* const table = expected_of(check, run).value;
    if (table == nullptr) return 0;
    const QuestionLog& log = worker.questions(exercise, check.case_name, seed);
    const TensorView view(*table);
    std::map<std::uint32_t, std::size_t> rows_of;
    for (std::size_t row = 0; row < view.cells(); ++row) {
        const auto question = log.question_of(check.value, row, view.cells());
        const QuestionKind* const kind = question ? log.kind_of(*question) : nullptr;
        // A function without arguments has one answer, and to write that down may be the exercise. Of a script of
        // events only how many there were is told.
        const auto is_count = [](const std::string& feature) { return feature.starts_with("the number of "); };
        if (kind == nullptr || std::ranges::all_of(kind->features, is_count)) continue;
        const auto cell = view.present(row) ? view.cell(row) : std::span<const double>();
        take({kind->function, bits_of(kind->questions.at(*question)), rows_of[*question]++, bits_of(cell)});
    }
    return view.cells();
}

}

double known_share(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds)
{
    if (check.relation || judge_of(check).counts_work || judge_of(check).look != Look::none) return 0;
    const auto seed = [&](unsigned number) { return seeds.other_seed_of(exercise, check.case_name, number); };
    std::set<KnownRow> known;
    for (unsigned number = 1; number <= written_down; ++number)
        visit_rows(worker, exercise, check, seed(number), [&](KnownRow row) { known.insert(std::move(row)); });
    std::size_t right = 0;
    const std::size_t rows = visit_rows(worker, exercise, check, seed(0),
                                        [&](const KnownRow& row) { right += known.contains(row) ? 1 : 0; });
    return rows == 0 ? 0 : static_cast<double>(right) / static_cast<double>(rows);
}

}
