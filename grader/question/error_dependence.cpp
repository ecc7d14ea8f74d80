#include "question/error_dependence.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "question/moved_places.hpp"

namespace umbral::grader {
namespace {

/// The only place with which this error of a number changes. Nothing if there are more or none, if for some move it is
/// neither clear that it changes nor that it stays, or if the right numbers change with nothing else.
std::optional<MovedPlace> only_place(const std::vector<MoveReactions>& moves, std::size_t number,
                                     Reaction Reactions::*error)
{
    std::set<MovedPlace> places;
    bool others_matter = false;
    for (const MoveReactions& move : moves) {
        const Reactions& reactions = move.numbers[number];
        const Reaction& of_error = reactions.*error;
        if (reactions.right.seen == 0) continue;
        if (of_error.changes())
            places.insert(move.place);
        else if (!of_error.stays())
            return std::nullopt;
        else
            others_matter = others_matter || (reactions.right.changes() && reactions.yours.changes());
    }
    const std::vector<MovedPlace> joined = joined_places(std::move(places), 1);
    return others_matter && !joined.empty() ? std::optional(joined.front()) : std::nullopt;
}

}

std::vector<ErrorDependence> error_dependences(const std::vector<MoveReactions>& moves)
{
    std::vector<ErrorDependence> all;
    for (std::size_t i = 0; i < numbers_of_answer(moves); ++i) {
        ErrorKind kind = ErrorKind::factor;
        auto place = only_place(moves, i, &Reactions::factor);
        if (!place) {
            kind = ErrorKind::difference;
            place = only_place(moves, i, &Reactions::difference);
        }
        if (!place) continue;
        const auto same = std::ranges::find_if(
            all, [&](const ErrorDependence& other) { return other.kind == kind && other.place == *place; });
        if (same != all.end())
            same->components.push_back(i);
        else
            all.push_back({{i}, kind, *std::move(place)});
    }
    return all;
}

}
