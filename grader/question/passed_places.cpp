#include "question/passed_places.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace umbral::grader {
namespace {

constexpr double least_on_their_side = 0.97;
constexpr double most_strays = 0.01;
constexpr std::size_t least_alone = 6;
constexpr std::size_t least_beside = 6;  ///< right ones
constexpr std::size_t most_parting_places = 16;

/// Wrong ones on the side where they belong, and right ones there.
struct Sides {
    double wrong = 0;
    double right = 0;
};

bool is_left_by_exception(const PassedPlaces& seen)
{
    return std::ranges::any_of(seen, [](const PassedQuestion& one) { return one.wrong && one.by_exception; });
}

Sides sides_of(const PartingPlace& place)
{
    const std::size_t wrong = place.of_wrong ? place.wrong_through : place.wrong - place.wrong_through;
    const std::size_t right = place.of_wrong ? place.right_through : place.right - place.right_through;
    return {static_cast<double>(wrong), static_cast<double>(right)};
}

}

bool are_wrong_where_given(const PassedPlaces& seen)
{
    return !seen.empty() && std::ranges::all_of(seen, [](const PassedQuestion& one) { return one.given == one.wrong; });
}

PassedPlaces without_idle(PassedPlaces seen)
{
    std::erase_if(seen, &PassedQuestion::idle);
    return seen;
}

PartingPlace place_among(const PartingPlace& place, const PassedPlaces& others)
{
    PartingPlace result{.place = place.place, .of_wrong = place.of_wrong, .but_idle = place.but_idle};
    for (const PassedQuestion& one : others) {
        const bool through = std::ranges::find(one.places, place.place) != one.places.end();
        ++(one.wrong ? result.wrong : result.right);
        if (through) ++(one.wrong ? result.wrong_through : result.right_through);
    }
    return result;
}

bool parts(const PartingPlace& place)
{
    const auto [wrong, strays] = sides_of(place);
    const auto all_wrong = static_cast<double>(place.wrong);
    const auto all_right = static_cast<double>(place.right);
    return wrong >= least_on_their_side * all_wrong && strays <= most_strays * all_right;
}

bool are_few(const PartingPlace& place) { return std::min(place.wrong, place.right) < least_alone; }

std::pair<double, double> strays_of(const PartingPlace& place)
{
    const auto share = [](double some, std::size_t all) { return all == 0 ? 0.0 : some / static_cast<double>(all); };
    const auto [wrong, strays] = sides_of(place);
    return {share(static_cast<double>(place.wrong) - wrong, place.wrong), share(strays, place.right)};
}

std::vector<PartingPlace> parting_places(const PassedPlaces& seen)
{
    const auto wrong = static_cast<std::size_t>(std::ranges::count(seen, true, &PassedQuestion::wrong));
    if (wrong < least_parted_questions || seen.size() - wrong < least_beside) return {};
    std::map<std::uint32_t, PartingPlace> all;
    for (const PassedQuestion& question : seen)
        for (const std::uint32_t place : question.places) {
            PartingPlace& one = all.try_emplace(place, PartingPlace{place}).first->second;
            ++(question.wrong ? one.wrong_through : one.right_through);
        }
    std::vector<PartingPlace> best;
    const auto offer = [&](PartingPlace place) {
        if (!parts(place)) return;
        if (!best.empty() && strays_of(place) < strays_of(best.front())) best.clear();
        if (best.empty() || strays_of(place) == strays_of(best.front())) best.push_back(place);
    };
    // In the order in which the questions of that kind reach them.
    for (const bool of_wrong : {true, false}) {
        if (!of_wrong && is_left_by_exception(seen)) break;
        std::set<std::uint32_t> offered;
        for (const PassedQuestion& question : seen) {
            if (question.wrong != of_wrong) continue;
            for (const std::uint32_t number : question.places) {
                if (!offered.insert(number).second) continue;
                PartingPlace place = all.at(number);
                place.of_wrong = of_wrong;
                place.wrong = wrong;
                place.right = seen.size() - wrong;
                offer(place);
            }
        }
    }
    if (best.size() > most_parting_places) best.resize(most_parting_places);
    return best;
}

}
