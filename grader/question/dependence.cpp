#include "question/dependence.hpp"

#include <algorithm>
#include <set>

#include "question/moved_places.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_places = 3;  ///< that are told, of what answers change with and of what they should

}

std::vector<Dependence> dependences(const std::vector<MoveReactions>& moves)
{
    std::vector<Dependence> all;
    for (std::size_t i = 0; i < numbers_of_answer(moves); ++i) {
        std::set<MovedPlace> wrongly;
        std::set<MovedPlace> lacking;
        bool is_constant = true;
        bool is_like_right = false;  ///< something is used as it should be
        for (const MoveReactions& move : moves) {
            const Reaction& yours = move.numbers[i].yours;
            const Reaction& right = move.numbers[i].right;
            is_constant = is_constant && yours.changed == 0;
            is_like_right = is_like_right || (yours.changes() && right.changes());
            if (yours.changes() && right.stays()) wrongly.insert(move.place);
            if (right.changes() && yours.stays()) lacking.insert(move.place);
        }
        if (is_constant) continue;
        Dependence one{
            {i}, joined_places(std::move(wrongly), most_places), joined_places(std::move(lacking), most_places)};
        if (one.wrongly.empty() && (one.lacking.empty() || !is_like_right)) continue;
        const auto same = std::ranges::find_if(
            all, [&](const Dependence& other) { return other.wrongly == one.wrongly && other.lacking == one.lacking; });
        if (same != all.end())
            same->components.push_back(i);
        else
            all.push_back(std::move(one));
    }
    return all;
}

}
