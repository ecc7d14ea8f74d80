#include "validate/unit_gaps.hpp"

#include <charconv>
#include <map>

#include "question/log.hpp"
#include "question/names.hpp"
#include "worker/interface_text.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

/// Which argument a place is a part of: 1 of "1.x", and of "the least number in 1". What has none is a part of the
/// first.
std::size_t argument_of(std::string_view place)
{
    const std::size_t digit = place.starts_with("the ") ? place.rfind(' ') + 1 : 0;
    std::size_t argument = 0;
    std::from_chars(place.data() + digit, place.data() + place.size(), argument);
    return argument;
}

CallsOfFunction named_calls(const QuestionKind& kind, const std::string& headers)
{
    CallsOfFunction calls;
    const std::vector<std::string> parameters = parameter_names(headers, kind.function);
    for (std::size_t i = 0; i < kind.features.size(); ++i) {
        calls.names.push_back(in_words(kind.features[i], parameters));
        calls.arguments.push_back(argument_of(kind.features[i]));
        calls.are_words.push_back(i < kind.words.size() && !kind.words[i].empty());
    }
    return calls;
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
                CallsOfFunction& calls =
                    functions.try_emplace({kind.function, kind.features}, named_calls(kind, headers)).first->second;
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
