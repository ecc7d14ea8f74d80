#include "validate/unit_gaps.hpp"

#include <map>

#include "question/log.hpp"
#include "question/names.hpp"
#include "worker/interface_text.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

std::vector<AskedNumber> numbers_of(const QuestionKind& kind, const std::string& headers)
{
    std::vector<AskedNumber> numbers;
    const std::vector<std::string> parameters = parameter_names(headers, kind.function);
    for (std::size_t i = 0; i < kind.features.size(); ++i) {
        const auto place = argument_place(kind.features[i]);
        numbers.push_back({in_words(kind.features[i], parameters), place ? place->argument : 0,
                           i < kind.words.size() && !kind.words[i].empty(), place && !place->before.empty()});
    }
    return numbers;
}

}

std::vector<FunctionGaps> unit_gaps(Worker& worker, const Exercise& exercise, unsigned sets)
{
    const std::string headers = interface_text(worker, exercise);
    std::map<std::pair<std::string, std::vector<std::string>>, CallsOfFunction> functions;
    for (const std::string& name : exercise.cases())
        for (unsigned set = 0; set < sets; ++set) {
            const QuestionLog& log = worker.questions(exercise, name, validation_seeds(set).seed_of(exercise, name));
            for (const QuestionKind& kind : log.kinds) {
                CallsOfFunction& calls = functions[{kind.function, kind.features}];
                if (calls.numbers.empty()) calls.numbers = numbers_of(kind, headers);
                calls.runs.emplace_back();
                for (const auto& [question, numbers] : kind.questions) calls.runs.back().push_back(numbers);
            }
        }
    std::vector<FunctionGaps> found;
    for (const auto& [key, calls] : functions) {
        FunctionGaps one{std::string(reflect::last_name(key.first)), 0, input_gaps(calls)};
        for (const auto& run : calls.runs) one.calls += run.size();
        found.push_back(std::move(one));
    }
    return found;
}

}
