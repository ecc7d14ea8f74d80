#include "question/movable.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "question/names.hpp"

namespace umbral::grader {
namespace {

constexpr std::string_view keeps_length = "moved direction";
constexpr double nearly_one = 1e-3;  ///< of the square of a length

/// Does the feature belong to what stands at `place`?
bool is_within(std::string_view feature, std::string_view place)
{
    return feature.starts_with(place) &&
           (feature.size() == place.size() || feature[place.size()] == '.' || feature[place.size()] == '[');
}

/// Have the numbers at the place together length 1 in all questions?
bool is_unit(const QuestionKind& kind, std::string_view place)
{
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < kind.features.size(); ++i)
        if (is_within(kind.features[i], place)) numbers.push_back(i);
    return numbers.size() > 1 && !kind.questions.empty() && std::ranges::all_of(kind.questions, [&](const auto& one) {
               double square = 0;
               for (const std::size_t i : numbers) square += one.second.at(i) * one.second.at(i);
               return std::abs(square - 1) <= nearly_one;
           });
}

/// Has the place, or one that it is a part of, length 1 in all questions?
bool is_within_unit(const QuestionKind& kind, std::string_view place)
{
    for (; !place.empty(); place = owner_of(place))
        if (is_unit(kind, place)) return true;
    return false;
}

/// Is it a matrix's entry that is 0 in all questions, or 1 in all: what makes it a matrix of its kind?
bool is_fixed_entry(const QuestionKind& kind, const OtherQuestion& move)
{
    constexpr std::string_view entry = "moved [";
    if (!move.change.starts_with(entry) || !move.change.ends_with(']')) return false;
    const std::string feature = move.place + move.change.substr(entry.size() - 1);
    const auto found = std::ranges::find(kind.features, feature);
    if (found == kind.features.end()) return false;
    const auto place = static_cast<std::size_t>(found - kind.features.begin());
    return std::ranges::all_of(kind.questions, [&](const auto& one) { return one.second.at(place) == 0; }) ||
           std::ranges::all_of(kind.questions, [&](const auto& one) { return one.second.at(place) == 1; });
}

}

std::vector<OtherQuestion> movable(const QuestionLog& log, const std::string& function)
{
    std::vector<OtherQuestion> all;
    const auto kind = std::ranges::find(log.kinds, function, &QuestionKind::function);
    if (kind == log.kinds.end()) return all;
    std::vector<std::string> unit_vectors;
    for (const OtherQuestion& move : log.moves)
        if (move.function == function && move.change == keeps_length && is_unit(*kind, move.place))
            unit_vectors.push_back(move.place);
    for (const OtherQuestion& move : log.moves) {
        if (move.function != function) continue;
        const bool is_unit_vector = std::ranges::find(unit_vectors, move.place) != unit_vectors.end();
        if (is_unit_vector != (move.change == keeps_length)) continue;
        const auto stands_beside = [&](const std::string& other) {
            return other != move.place && !owner_of(other).empty() && owner_of(other) == owner_of(move.place);
        };
        if (is_unit_vector && std::ranges::any_of(unit_vectors, stands_beside)) continue;
        if (is_fixed_entry(*kind, move)) continue;
        const std::string part =
            move.place + (move.change.ends_with(']') ? move.change.substr(move.change.find('[')) : "");
        if (!is_within_unit(*kind, owner_of(part))) all.push_back(move);
    }
    return all;
}

bool is_of_unit_length(const QuestionLog& log, const OtherQuestion& question)
{
    const auto kind = std::ranges::find(log.kinds, question.function, &QuestionKind::function);
    return kind != log.kinds.end() && is_within_unit(*kind, question.place);
}

}
