#include "question/moved_places.hpp"

#include <map>
#include <optional>
#include <string_view>

namespace umbral::grader {
namespace {

/// The vector that a component is one of; nothing if it is none.
std::optional<MovedPlace> vector_of(const MovedPlace& place)
{
    const std::size_t dot = place.place.rfind('.');
    const bool is_component = dot != std::string::npos && dot + 2 == place.place.size() &&
                              std::string_view("xyzw").find(place.place.back()) != std::string_view::npos;
    if (!is_component) return std::nullopt;
    return MovedPlace{place.function, place.place.substr(0, dot)};
}

/// A vector in place of three of its components, or of one beside its length.
void join_components(std::set<MovedPlace>& places)
{
    std::map<MovedPlace, std::size_t> components;
    for (const MovedPlace& place : places)
        if (const auto vector = vector_of(place)) ++components[*vector];
    std::set<MovedPlace> whole;
    for (const MovedPlace& place : places)
        if (!place.is_length && !vector_of(place)) whole.insert(place);
    for (const auto& [vector, count] : components)
        if (count >= 3 || places.contains({vector.function, vector.place, true})) whole.insert(vector);
    std::erase_if(places, [&](const MovedPlace& place) {
        const auto vector = vector_of(place);
        return (vector && whole.contains(*vector)) ||
               (place.is_length && whole.contains({place.function, place.place, false}));
    });
    places.merge(whole);
}

}

MovedPlace moved_place(const OtherQuestion& move)
{
    constexpr std::string_view moved = "moved";
    std::string_view what = std::string_view(move.change).substr(moved.size());
    if (what.starts_with(' ')) what.remove_prefix(1);
    const bool is_length = what == "length";
    const bool is_order = what == "order";
    const bool is_corners = what == "corners";
    if (what == "direction" || is_length || is_order || is_corners) what = {};
    return {move.function, move.place + std::string(what), is_length, is_order, is_corners};
}

std::vector<MovedPlace> joined_places(std::set<MovedPlace> places, std::size_t most)
{
    join_components(places);
    if (places.size() > most) return {};
    return {places.begin(), places.end()};
}

}
