#include "question/dependence.hpp"

#include <algorithm>
#include <set>

#include "question/moved_places.hpp"
#include "question/reactions.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_places = 3;  ///< that are told, of what answers change with and of what they should

}

std::vector<Dependence> dependences(const AnswersToMoves& answers)
{
    std::vector<Dependence> all;
    const std::vector<std::vector<Reactions>> all_reactions = reactions(answers);
    for (std::size_t i = 0; i < answers.components; ++i) {
        std::set<MovedPlace> wrongly;
        std::set<MovedPlace> lacking;
        bool is_constant = true;
        bool is_like_right = false;  ///< something is used as it should be
        for (std::size_t m = 0; m < answers.moved.size(); ++m) {
            const Reaction& yours = all_reactions[m][i].yours;
            const Reaction& right = all_reactions[m][i].right;
            is_constant = is_constant && yours.changed == 0;
            is_like_right = is_like_right || (yours.changes() && right.changes());
            if (yours.changes() && right.stays()) wrongly.insert(moved_place(answers.moved[m].move));
            if (right.changes() && yours.stays()) lacking.insert(moved_place(answers.moved[m].move));
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
