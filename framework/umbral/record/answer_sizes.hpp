#pragma once

#include <iterator>
#include <limits>
#include <tuple>
#include <umbral/record/features.hpp>
#include <umbral/record/place.hpp>
#include <utility>

namespace umbral {

/// Adds how many elements each list in `value` has, which stands at `place`: of structs, those in their fields; texts
/// are lists of letters. What has a fixed length is no list. Equal types have equal names, whatever their values.
template <class Value>
void add_sizes(const Place& place, const Value& value, Features& sizes)
{
    namespace of = literal::detail;
    const auto name = [&place] { return place.text(); };
    if constexpr (std::is_pointer_v<Value>) {
        // Null, or of any length.
    } else if constexpr (of::Text<Value>) {
        sizes.add(static_cast<double>(std::string_view(value).size()), name);
    } else if constexpr (of::List<Value> && !reflect::is_plain_struct<Value>) {
        sizes.add(static_cast<double>(std::ranges::size(value)), name);
    } else if constexpr (reflect::is_plain_struct<Value> && !of::List<Value> && !of::is_grid<Value>) {
        reflect::for_each_field(
            value, [&](std::string_view field, const auto& inner) { add_sizes(place / field, inner, sizes); });
    }
}

namespace detail {

/// Of the arguments that a call may write to.
template <class... Kept>
Features sizes_of_arguments(const std::tuple<Kept...>& arguments, bool named)
{
    Features sizes{.named = named};
    const auto add_argument = [&]<std::size_t Index>(std::integral_constant<std::size_t, Index>) {
        using Type = std::tuple_element_t<Index, std::tuple<Kept...>>;
        if constexpr (std::is_lvalue_reference_v<Type> && !std::is_const_v<std::remove_reference_t<Type>>)
            add_sizes(Place{Index}, std::get<Index>(arguments), sizes);
    };
    [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        (add_argument(std::integral_constant<std::size_t, Index>()), ...);
    }
    (std::index_sequence_for<Kept...>{});
    return sizes;
}

/// Of what was answered: of the value that was returned, called by the names of its fields alone, and of the arguments
/// that the call may have written to, NaN where one held anything `before`.
template <class Result, class... Kept>
Features sizes_of(const Result* result, const std::tuple<Kept...>& arguments, const Features& before, bool named)
{
    Features sizes{.named = named};
    if constexpr (!std::is_void_v<Result>) add_sizes(Place{Place::no_argument}, *result, sizes);
    Features after = sizes_of_arguments(arguments, named);
    for (std::size_t i = 0; i < after.values.size(); ++i)
        sizes.values.push_back(before.values.at(i) == 0 ? after.values[i] : std::numeric_limits<double>::quiet_NaN());
    std::ranges::move(after.names, std::back_inserter(sizes.names));
    return sizes;
}

}
}
