#include "question/error_dependence.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "question/moved_places.hpp"
#include "question/reactions.hpp"

namespace umbral::grader {
namespace {

/// The only place with which this error of a number changes. Nothing if there are more or none, if for some move it is
/// neither clear that it changes nor that it stays, or if the right numbers change with nothing else.
std::optional<MovedPlace> only_place(const AnswersToMoves& answers, std::size_t number,
                                     const std::vector<std::vector<Reactions>>& all, Reaction Reactions::*error)
{
    std::set<MovedPlace> places;
    bool others_matter = false;
    for (std::size_t m = 0; m < answers.moved.size(); ++m) {
        const Reactions& reactions = all[m][number];
        const Reaction& of_error = reactions.*error;
        if (reactions.right.seen == 0) continue;
        if (of_error.changes())
            places.insert(moved_place(answers.moved[m].move));
        else if (!of_error.stays())
            return std::nullopt;
        else
            others_matter = others_matter || (reactions.right.changes() && reactions.yours.changes());
    }
    const std::vector<MovedPlace> joined = joined_places(std::move(places), 1);
    return others_matter && !joined.empty() ? std::optional(joined.front()) : std::nullopt;
}

}

std::vector<ErrorDependence> error_dependences(const AnswersToMoves& answers)
{
    std::vector<ErrorDependence> all;
    const std::vector<std::vector<Reactions>> moved = reactions(answers);
    for (std::size_t i = 0; i < answers.components; ++i) {
        ErrorKind kind = ErrorKind::factor;
        auto place = only_place(answers, i, moved, &Reactions::factor);
        if (!place) {
            kind = ErrorKind::difference;
            place = only_place(answers, i, moved, &Reactions::difference);
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
