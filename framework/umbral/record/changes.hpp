#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <umbral/record/place.hpp>
#include <umbral/record/ways_to_change.hpp>
#include <umbral/record/ways_to_move.hpp>
#include <utility>
#include <vector>

namespace umbral {

/// A part of a question's arguments that can be misunderstood as a whole: a number, a vector, a matrix, a list.
struct Part {
    Place place;                   ///< as in Features: "0.direction"
    std::string_view type;         ///< two parts of one type can be taken for each other
    std::string_view owner{};      ///< the type of the struct that it is a field of; empty for an argument
    bool of_element = false;       ///< a field of a list's element, which is changed with all others of its kind only
    const void* within = nullptr;  ///< the struct itself
    void* value = nullptr;
    std::span<const Change> changes{};
    std::span<const Change> moves{};  ///< ways_to_move.hpp
    void (*exchange)(void* one, void* other) = nullptr;
    void (*take)(void* one, const void* other) = nullptr;
};

namespace detail {

template <class Value>
inline constexpr bool is_list_of_structs = false;
template <class Element>
inline constexpr bool is_list_of_structs<std::vector<Element>> =
    reflect::is_plain_struct<Element> && !literal::detail::is_vector<Element>;
/// So many elements of a list have fields that are changed with others of their kind: of chains, not of meshes.
inline constexpr std::size_t most_elements = 64;

template <class Value>
void exchange(void* one, void* other)
{
    std::swap(*static_cast<Value*>(one), *static_cast<Value*>(other));
}

template <class Value>
void take(void* one, const void* other)
{
    if constexpr (std::is_copy_assignable_v<Value>) *static_cast<Value*>(one) = *static_cast<const Value*>(other);
}

/// The struct that a value is a field of, and its type; nothing of an argument.
struct Owner {
    std::string_view type{};
    const void* value = nullptr;
    bool is_element = false;  ///< or is part of one
};

}

/// Adds the parts of `value`, which stands at `place`, and itself if it is one.
template <class Value>
void add_parts(const Place& place, Value& value, std::vector<Part>& parts, const detail::Owner& owner = {})
{
    if constexpr (detail::is_list_of_structs<Value>)
        for (std::size_t i = 0; i < std::min(value.size(), detail::most_elements); ++i)
            add_parts(place, value[i], parts, {{}, nullptr, true});
    constexpr bool is_struct = reflect::is_plain_struct<Value> && std::is_swappable_v<Value>;
    constexpr bool is_one = !detail::ChangesOf<Value>::all.empty();
    if constexpr (is_one || is_struct)
        parts.push_back({place, reflect::type_name<Value>(), owner.type, owner.is_element, owner.value, &value,
                         detail::ChangesOf<Value>::all, detail::MovesOf<Value>::all, detail::exchange<Value>,
                         detail::take<Value>});
    if constexpr (!is_one && is_struct)
        reflect::for_each_field(value, [&](std::string_view name, auto& field) {
            const std::string_view type = name.starts_with('[') ? "" : reflect::type_name<Value>();
            add_parts(place / name, field, parts, {type, &value, owner.is_element});
        });
}

/// Of an other question: the part at `other` is used in place of that at `place`, as well as for itself.
inline constexpr std::string_view taken_for_another = "taken as";

/// Of an other question: calls of the function, which only change their object, are not made.
inline constexpr std::string_view left_out = "left out";

/// So many parts are taken for one: those that are declared near it, which is where lines are copied from.
inline constexpr std::size_t most_taken_for_one = 8;

/// A part of the calls of a function.
struct OtherPlace {
    std::string function;
    std::string place;

    friend bool operator==(const OtherPlace&, const OtherPlace&) = default;
};

/// A question asked in place of another: in calls of `function`, the part at `place` is changed so, exchanged with the
/// part at `other`, or taken as that. Without a function, `place` is a field of a struct, "umbral::AxisAngle.angle",
/// `other` one of the same struct, and all such parts of all calls are changed: what is misunderstood in a helper is
/// misunderstood everywhere.
struct OtherQuestion {
    std::string function;
    std::string place;
    std::string change;  ///< the name of a Change or of a move, taken_for_another or left_out; empty: an exchange
    std::string other;
    std::vector<OtherPlace> also{};  ///< changed in the same way at the same time

    friend bool operator==(const OtherQuestion&, const OtherQuestion&) = default;
};

/// All that can be asked with these parts in place of what was asked. What all calls of the struct's field mean follows
/// what means those of this function.
[[nodiscard]] std::vector<OtherQuestion> other_questions(std::string_view function, std::span<const Part> parts);

/// All small changes of these parts, by which it shows what answers depend on.
[[nodiscard]] std::vector<OtherQuestion> moved_questions(std::string_view function, std::span<const Part> parts);

/// The field that a part is, as an OtherQuestion without a function names it; empty for an argument.
[[nodiscard]] std::string field_of(const Part& part);

/// Asks an other question: changes the calls that it means.
class AskedInstead {
public:
    explicit AskedInstead(const OtherQuestion& question);

    /// May a call of the function be changed?
    [[nodiscard]] bool means(std::string_view function) const;
    /// Are calls of the function not made?
    [[nodiscard]] bool leaves_out(std::string_view function) const;
    /// Changes the parts of a call as the question says; where they have no such place, nothing.
    void change(std::string_view function, std::span<const Part> parts);

private:
    /// A part that the question means, and where it stood in the call before: there may be more parts in this one, of
    /// longer lists.
    struct Known {
        std::string text;
        std::optional<Place> place{};
        std::size_t index = 0;

        [[nodiscard]] const Part* among(std::span<const Part> parts);
    };
    struct Changed {
        std::string function;
        Known part;
        Known other;
        bool is_looked_for = true;  ///< no call had no such part
    };

    void change_fields(std::span<const Part> parts) const;

    std::string change_;
    std::vector<Changed> changed_;
};

}
