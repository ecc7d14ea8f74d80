#include "explain/wrong_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "explain/other_cases.hpp"
#include "explain/samples.hpp"
#include "text/joined.hpp"
#include "worker/spent_on_runs.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t least_right = 4;  ///< answers of the other functions: of fewer it may be chance
constexpr std::size_t most_others_named = 3;

struct Count {
    std::size_t wrong = 0;
    std::size_t all = 0;
};

}

std::string wrong_function(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left()) return "";
    const SpentOnRuns spent(time, worker);
    const std::uint64_t seed = input_seed(asked, 0);
    const QuestionLog& log = questions_at(worker, asked, seed);
    std::map<std::string, Count> functions;
    for (const AskedAnswer& one : asked_answers(worker, asked, seed).all) {
        const QuestionKind* const kind = log.kind_of(one.question);
        if (kind == nullptr) return "";
        Count& count = functions[kind->function];
        ++count.all;
        count.wrong += one.answer.wrong ? 1 : 0;
    }
    const auto is_wrong = [](const auto& one) { return one.second.wrong > 0; };
    if (functions.size() < 2 || std::ranges::count_if(functions, is_wrong) != 1) return "";
    const auto& [function, count] = *std::ranges::find_if(functions, is_wrong);
    std::vector<std::string> others;
    std::size_t right = 0;
    for (const auto& [name, other] : functions) {
        if (name == function) continue;
        others.emplace_back(reflect::last_name(name));
        right += other.all;
    }
    if (right < least_right) return "";
    // What this check asks of the others may show too little of their answers.
    OtherCases elsewhere(worker, asked);
    bool is_wrong_elsewhere = false;
    for (const auto& [name, other] : functions)
        if (name != function)
            elsewhere.each(name, [&](const AskedSample& sample) {
                is_wrong_elsewhere = is_wrong_elsewhere || wrong_in(sample.answers) > 0;
                return !is_wrong_elsewhere;
            });
    if (is_wrong_elsewhere) return "";
    if (others.size() > most_others_named) {
        const std::size_t more = others.size() - most_others_named;
        others.resize(most_others_named);
        others.push_back(fmt::format("{} other{}", more, more == 1 ? "" : "s"));
    }
    return fmt::format("only answers of {} are wrong ({} of {}), none of {} ({})", reflect::last_name(function),
                       count.wrong, count.all, joined_with_and(others), right);
}

}
