#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <umbral/record/literal.hpp>
#include <umbral/record/place.hpp>
#include <vector>

namespace umbral {

/// Numbers that say what a question was about, each with the place in its arguments: "0.origin.x" is the x of the field
/// `origin` of the first argument. Equal types have equal places, whatever their values, so that names are needed once.
struct Features {
    bool named = true;
    std::vector<std::string> names{};
    std::vector<double> values{};

    /// Between a name and the words for 0, 1, … of a number that stands for one of them: "1.rule|even_odd|nonzero".
    static constexpr char before_word = '|';

    /// `name` is called only where names are wanted.
    template <class Name>
    void add(double value, const Name& name)
    {
        values.push_back(value);
        if (named) names.push_back(name());
    }
};

/// Of a list, about so many numbers are looked at: of meshes and chains of thousands the first.
inline constexpr std::size_t most_numbers_of_list = 2000;

/// Of arrays up to this length each element is looked at by itself.
inline constexpr std::size_t most_single_elements = 4;

inline constexpr std::string_view component_names[] = {"x", "y", "z", "w"};

namespace detail {

/// "|even_odd|nonzero": the enumerators, from 0 on.
template <class Enum>
std::string words_of()
{
    std::string words;
    [&]<int... Value>(std::integer_sequence<int, Value...>)
    {
        ((words.append(1, Features::before_word)
              .append(reflect::last_name(reflect::value_name<static_cast<Enum>(Value)>()))),
         ...);
    }
    (std::make_integer_sequence<int, reflect::enumerators<Enum>>{});
    return words;
}

template <class Value>
inline constexpr bool is_short_array = false;
template <class Element, std::size_t Count>
inline constexpr bool is_short_array<std::array<Element, Count>> = (Count <= most_single_elements);

}

template <class Value>
void add_features(const Place& place, const Value& value, Features& features);

namespace detail {

/// Equal for elements with equal numbers: 0 and -0 are, and so is what is no number.
[[nodiscard]] inline std::vector<std::uint64_t> key_of(std::span<const double> numbers)
{
    std::vector<std::uint64_t> key;
    for (const double number : numbers)
        key.push_back(std::isnan(number) ? 1 : std::bit_cast<std::uint64_t>(number + 0.0));
    return key;
}

/// How many elements the shortest and the longest have; of no lists 0.
template <class Lists>
void add_lengths(const Place& place, const Lists& lists, Features& features)
{
    std::size_t shortest = 0;
    std::size_t longest = 0;
    for (bool is_first = true; const auto& list : lists) {
        shortest = is_first ? list.size() : std::min(shortest, list.size());
        longest = std::max(longest, list.size());
        is_first = false;
    }
    features.add(static_cast<double>(shortest), [&] { return "the length of the shortest list in " + place.text(); });
    features.add(static_cast<double>(longest), [&] { return "the length of the longest list in " + place.text(); });
}

/// How many there are, how many different ones, the least and the largest number in them; of lists their lengths too.
template <class List>
void add_features_of_list(const Place& place, const List& list, Features& features)
{
    Features inside{.named = false};
    std::set<std::vector<std::uint64_t>> different;
    std::size_t equal = 0;
    for (const auto& element : list) {
        if (inside.values.size() >= most_numbers_of_list) break;
        const std::size_t before = inside.values.size();
        add_features(place, element, inside);
        equal += different.insert(key_of(std::span(inside.values).subspan(before))).second ? 0 : 1;
    }
    const auto with = [&](const char* words) { return [&place, words] { return words + place.text(); }; };
    const auto [least, largest] = std::minmax_element(inside.values.begin(), inside.values.end());
    features.add(static_cast<double>(list.size()), [&] { return place.text() + ".size()"; });
    features.add(static_cast<double>(list.size() - equal), with("the number of different elements in "));
    features.add(inside.values.empty() ? 0 : *least, with("the least number in "));
    features.add(inside.values.empty() ? 0 : *largest, with("the largest number in "));
    using Element = std::remove_cvref_t<decltype(*list.begin())>;
    if constexpr (literal::detail::List<Element> && !literal::detail::Text<Element> && !is_short_array<Element>)
        add_lengths(place, list, features);
}

}

/// Adds the numbers in `value`, which stands at `place`. Lists give their lengths, how many different elements they
/// have, their least and their largest number; arrays of up to four elements are no lists.
template <class Value>
void add_features(const Place& place, const Value& value, Features& features)
{
    namespace of = literal::detail;
    const auto with = [&](const char* end) { return [&place, end] { return place.text() + end; }; };
    if constexpr (std::is_same_v<Value, bool>) {
        features.add(value ? 1 : 0, with("|false|true"));
    } else if constexpr (std::is_enum_v<Value>) {
        features.add(static_cast<double>(value), [&] { return place.text() + detail::words_of<Value>(); });
    } else if constexpr (std::is_arithmetic_v<Value>) {
        features.add(static_cast<double>(value), [&] { return place.text(); });
    } else if constexpr (of::is_vector<Value>) {
        for (glm::length_t i = 0; i < Value::length(); ++i)
            features.add(static_cast<double>(value[i]), [&] { return (place / component_names[i]).text(); });
    } else if constexpr (of::is_matrix<Value>) {
        for (glm::length_t column = 0; column < Value::length(); ++column)
            for (glm::length_t row = 0; row < Value::col_type::length(); ++row)
                features.add(static_cast<double>(value[column][row]), [&] {
                    return place.text() + "[" + std::to_string(column) + "][" + std::to_string(row) + "]";
                });
    } else if constexpr (of::is_optional<Value>) {
        features.add(value.has_value() ? 1 : 0, with(".has_value()"));
    } else if constexpr (of::Text<Value>) {
        features.add(static_cast<double>(std::string_view(value).size()), with(".size()"));
    } else if constexpr (of::is_grid<Value>) {
        features.add(value.width, with(".width"));
        features.add(value.height, with(".height"));
    } else if constexpr (of::List<Value> && !detail::is_short_array<Value>) {
        detail::add_features_of_list(place, value, features);
    } else if constexpr (reflect::is_plain_struct<Value>) {
        reflect::for_each_field(
            value, [&](std::string_view name, const auto& field) { add_features(place / name, field, features); });
    }
}

}
