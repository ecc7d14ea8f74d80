#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <umbral/record/literal.hpp>
#include <umbral/record/questions.hpp>
#include <utility>

/// A question as code: the call with its arguments, which can be pasted into a test.
namespace umbral::detail {

template <class List>
concept GrowingList = requires(List& list)
{
    list.push_back(*list.begin());
};

/// Is it what the function changes, and the caller goes on with? Kept is what ask() keeps of a parameter.
template <class Kept>
inline constexpr bool is_changed =
    std::is_lvalue_reference_v<Kept> && !std::is_const_v<std::remove_reference_t<Kept>> &&
    std::is_copy_constructible_v<std::remove_reference_t<Kept>> && !std::is_abstract_v<std::remove_reference_t<Kept>>;

/// Is it a list that the function adds its results to?
template <class Kept>
inline constexpr bool is_list_to_fill = is_changed<Kept>&& GrowingList<std::remove_reference_t<Kept>>;

inline constexpr const char* filled_list = "filled";  ///< what such a list is called in code

/// What the arguments that are changed are called in code: "filled" the list, "changed" and "changed_2" others; empty
/// what is none.
template <class... Kept>
std::array<std::string, sizeof...(Kept)> names_of_changed()
{
    static_assert((0 + ... + int{is_list_to_fill<Kept>}) <= 1, "two lists that are filled need two names");
    std::array<std::string, sizeof...(Kept)> names;
    std::size_t place = 0;
    int changed = 0;
    [[maybe_unused]] const auto add = [&](bool is_list, bool is_any) {
        std::string& name = names[place++];
        if (is_list)
            name = filled_list;
        else if (is_any)
            name = ++changed == 1 ? "changed" : "changed_" + std::to_string(changed);
    };
    (add(is_list_to_fill<Kept>, is_changed<Kept>), ...);
    return names;
}

/// An argument as code: in full if that is asked for.
template <class Value>
std::string argument_text(const Questions& questions, const Value& value)
{
    return literal::of_value(value, true, questions.inquiry().in_full ? literal::in_full : literal::Style{});
}

/// "intersect(Ray{…}, Sphere{…})"; an argument by its name if it has one in `names`, or is an object that has one.
template <class... Kept>
std::string call_text(const Questions& questions, std::string_view function, const std::tuple<Kept...>& arguments,
                      const std::array<std::string, sizeof...(Kept)>& names = {})
{
    std::string text(reflect::last_name(function));
    text += '(';
    std::size_t count = 0;
    const auto add = [&](const auto& argument, bool may_have_a_name) {
        const std::string& given = names[count];
        if (count++ > 0) text += ", ";
        if (const std::string name = questions.name_of(&argument); may_have_a_name && !name.empty())
            text += name;
        else
            text += given.empty() ? argument_text(questions, argument) : given;
    };
    [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        (add(std::get<Index>(arguments), std::is_reference_v<Kept>), ...);
    }
    (std::index_sequence_for<Kept...>{});
    return text + ')';
}

/// The call, between lines that make what it changes, and name what comes out: what it returns, or else the list that
/// it fills, or the first of what it changes.
template <class Result, class... Kept>
std::string code_of_call(const Questions& questions, std::string_view function, const std::tuple<Kept...>& arguments)
{
    std::array<std::string, sizeof...(Kept)> names = names_of_changed<Kept...>();
    std::string made;
    std::string comes_out;
    std::size_t place = 0;
    [[maybe_unused]] const auto make = [&](const auto& argument) {
        std::string& name = names[place++];
        // Objects that were made before have names of their own.
        if (!questions.name_of(&argument).empty()) name.clear();
        if (name.empty()) return;
        made += "auto " + name + " = " + argument_text(questions, argument) + ";\n";
        if (comes_out.empty() || name == filled_list) comes_out = name;
    };
    [&]<std::size_t... Index>(std::index_sequence<Index...>) { (make(std::get<Index>(arguments)), ...); }
    (std::index_sequence_for<Kept...>{});
    const std::string call = made + call_text(questions, function, arguments, names);
    const bool is_told = !std::is_void_v<Result> && comes_out != filled_list;
    return comes_out.empty() || is_told ? call : call + ";\n" + comes_out;
}

}
