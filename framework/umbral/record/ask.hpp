#pragma once

#include <cstdlib>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <umbral/record/answer_sizes.hpp>
#include <umbral/record/call_text.hpp>
#include <umbral/record/questions.hpp>
#include <umbral/record/recorder.hpp>
#include <umbral/record/short_lived.hpp>
#include <utility>

/// How a driver calls a unit: `ask<intersect>(out, ray, sphere)` returns what `intersect(ray, sphere)` does. What is
/// recorded from then on, until the next question, are its answers.
///
/// So the framework knows which question led to which row, and can write it as code, find what the questions with wrong
/// answers have in common, and ask a trusted solution others in their place. In a student's run it does nothing but
/// call.
namespace umbral {
namespace detail {

/// What a parameter's value is kept as while it is changed; what is written to, or refers to an object, is passed on.
template <class Parameter>
struct Kept {
    using Value = std::remove_cvref_t<Parameter>;
    static constexpr bool is_copied =
        std::is_copy_constructible_v<Value> && !std::is_pointer_v<Value> && !std::is_abstract_v<Value> &&
        (!std::is_lvalue_reference_v<Parameter> || std::is_const_v<std::remove_reference_t<Parameter>>);
    using Type = std::conditional_t<is_copied, Value, std::add_lvalue_reference_t<std::remove_reference_t<Parameter>>>;
};
template <class Element, std::size_t Extent>
struct Kept<std::span<const Element, Extent>> {
    static constexpr bool is_copied = true;
    using Type = std::vector<Element>;
};
template <class Result, class... Arguments>
struct Kept<const std::function<Result(Arguments...)>&> {
    static constexpr bool is_copied = false;
    using Type = const std::function<Result(Arguments...)>&;
};
template <>
struct Kept<std::string_view> {
    static constexpr bool is_copied = true;
    using Type = std::string;
};

/// A copy that can be changed, or a reference.
template <class Parameter, class Argument>
typename Kept<Parameter>::Type kept(Argument& argument)
{
    using Type = typename Kept<Parameter>::Type;
    if constexpr (std::is_reference_v<Type>)
        return argument;
    else if constexpr (requires { Type(argument.begin(), argument.end()); } &&
                       !std::is_same_v<Type, std::remove_cvref_t<Argument>>)
        return Type(argument.begin(), argument.end());
    else
        return Type(argument);
}

template <class... Kept>
std::vector<Part> parts_of(std::tuple<Kept...>& arguments)
{
    std::vector<Part> parts;
    parts.reserve(16);
    [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        (add_parts(Place{Index}, std::get<Index>(arguments), parts), ...);
    }
    (std::index_sequence_for<Kept...>{});
    return parts;
}

/// Takes down what there is to say of a question to `function`.
template <class AddFeatures, class PartsOf>
void note(Questions& questions, std::string_view function, const AddFeatures& add_to, const PartsOf& parts)
{
    if (!questions.inquiry().questions) return;
    const bool known = questions.knows(function);
    Features features{.named = !known};
    add_to(features);
    if (!known) questions.introduce(function, features, parts());
    questions.set_features(function, features);
}

/// The same of a call, and asks another in its place if one is to be asked.
template <class... Kept>
void note(Questions& questions, std::string_view function, std::tuple<Kept...>& arguments)
{
    const auto add_to = [&](Features& features) {
        [&]<std::size_t... Index>(std::index_sequence<Index...>)
        {
            (add_features(Place{Index}, std::get<Index>(arguments), features), ...);
        }
        (std::index_sequence_for<Kept...>{});
    };
    note(questions, function, add_to, [&] { return parts_of(arguments); });
    if (questions.asks_instead_of(function)) questions.change(function, parts_of(arguments));
}

/// Is one of the arguments an object that the driver goes on with? A copy is none, though it may lie where one was.
template <class... Kept>
bool has_object(const Questions& questions, const std::tuple<Kept...>& arguments)
{
    return [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        return ((std::is_reference_v<Kept> && questions.is_object(&std::get<Index>(arguments))) || ...);
    }
    (std::index_sequence_for<Kept...>{});
}

/// What `call` returns, a call of `function` with these arguments. How long the lists in it are is taken down.
template <class Result, class... Kept, class Call>
Result answered(Questions& questions, std::string_view function, const std::tuple<Kept...>& arguments, const Call& call)
{
    constexpr bool can_be_looked_at = std::is_object_v<Result> && std::is_move_constructible_v<Result>;
    const bool is_wanted = questions.inquiry().questions;
    const Features before = is_wanted ? sizes_of_arguments(arguments, false) : Features{};
    const auto take_down = [&](const auto* result) {
        if (is_wanted)
            questions.set_sizes(function, sizes_of(result, arguments, before, !questions.knows_sizes(function)));
    };
    if constexpr (can_be_looked_at) {
        Result result = call();
        take_down(&result);
        return result;
    } else if constexpr (std::is_void_v<Result>) {
        call();
        take_down(static_cast<const void*>(nullptr));
    } else {
        return call();
    }
}

/// What the driver goes on with where a question must not be asked. What has no empty value, or would be used as an
/// object, ends the case.
template <class Result>
Result no_answer(const Recorder& out)
{
    if constexpr (!std::is_void_v<Result>) {
        constexpr bool owns = requires { typename std::remove_reference_t<Result>::element_type; };
        if constexpr (std::is_default_constructible_v<Result> && !std::is_pointer_v<Result> && !owns) return Result{};
        out.end_case();
        std::abort();  // end_case() does not return
    }
}

template <auto Function, class Result, class... Parameters>
struct AskFunction {
    static constexpr std::string_view name = reflect::value_name<Function>();

    Result operator()(Recorder& out, Parameters... arguments) const
    {
        Questions* const questions = out.questions();
        if (questions == nullptr) {
            if (out.passes_over(name)) return no_answer<Result>(out);
            return Function(std::forward<Parameters>(arguments)...);
        }
        std::tuple<typename Kept<Parameters>::Type...> all(kept<Parameters>(arguments)...);
        questions->begin();
        const bool is_to_object = has_object(*questions, all);
        if (is_to_object) questions->note_object(name);
        if (questions->code_is_wanted())
            questions->set_code((is_to_object ? questions->history() : "") +
                                code_of_call<Result>(*questions, name, all));
        note(*questions, name, all);
        const EndOfCall end(*questions);
        return answered<Result>(*questions, name, all, [&]() -> Result {
            return std::apply([](auto&... each) -> Result { return Function(each...); }, all);
        });
    }
};

template <auto Function, bool Changes, class Result, class Object, class... Parameters>
struct AskMember {
    static constexpr std::string_view name = reflect::value_name<Function>();

    Result operator()(Recorder& out, Object& object, Parameters... arguments) const
    {
        Questions* const questions = out.questions();
        if (questions == nullptr) {
            if (out.passes_over(name)) return no_answer<Result>(out);
            return (object.*Function)(std::forward<Parameters>(arguments)...);
        }
        std::tuple<typename Kept<Parameters>::Type...> all(kept<Parameters>(arguments)...);
        questions->begin();
        std::string called = questions->name_of(&object);
        called = called.empty() ? literal::object_name(reflect::type_name<std::remove_const_t<Object>>()) + "."
                                : called + "->";
        const bool known = questions->is_object(&object) || has_object(*questions, all);
        if (known) questions->note_object(name);
        if (questions->code_is_wanted() || Changes) {
            called += call_text(*questions, name, all);
            if (questions->code_is_wanted()) questions->set_code((known ? questions->history() : "") + called);
            if (Changes) questions->add_line(&object, called + ";");
        }
        if (Changes && known) questions->note_change(name);
        note(*questions, name, all);
        if constexpr (Changes && std::is_void_v<Result>) {
            questions->may_leave_out(name);
            if (questions->leaves_out(name)) return;
        }
        const EndOfCall end(*questions);
        return answered<Result>(*questions, name, all, [&]() -> Result {
            return std::apply([&](auto&... each) -> Result { return (object.*Function)(each...); }, all);
        });
    }
};

template <auto Function>
struct AskerOf;
template <class Result, class... Parameters, Result (*Function)(Parameters...)>
struct AskerOf<Function> : AskFunction<Function, Result, Parameters...> {
};
template <class Result, class... Parameters, Result (*Function)(Parameters...) noexcept>
struct AskerOf<Function> : AskFunction<Function, Result, Parameters...> {
};
template <class Result, class Class, class... Parameters, Result (Class::*Function)(Parameters...)>
struct AskerOf<Function> : AskMember<Function, true, Result, Class, Parameters...> {
};
template <class Result, class Class, class... Parameters, Result (Class::*Function)(Parameters...) const>
struct AskerOf<Function> : AskMember<Function, false, Result, const Class, Parameters...> {
};

}

/// Calls a function, ask<f>(out, arguments…), or an object's, ask<&C::f>(out, object, arguments…). Of an overloaded
/// function, say which: ask<static_cast<bool (*)(int)>(f)>.
template <auto Function>
inline constexpr detail::AskerOf<Function> ask{};

/// Calls a function that makes an object, returned by a pointer; questions to the object then begin with this call and
/// all that changed it since. `name` is what the object is called in them. The arguments that the function gets are
/// gone when the object is made, as a caller's may be.
template <auto Factory, class... Arguments>
[[nodiscard]] auto ask_new(Recorder& out, std::string_view name, Arguments&&... arguments)
{
    const ShortLived<std::remove_cvref_t<Arguments>...> short_lived(arguments...);
    auto object = short_lived.apply([&](const auto&... each) { return ask<Factory>(out, each...); });
    if (Questions* const questions = out.questions(); questions != nullptr && object) {
        const std::tuple<const std::remove_reference_t<Arguments>&...> all(arguments...);
        questions->note_change(reflect::value_name<Factory>());
        questions->set_object(object.get(), name,
                              "const auto " + std::string(name) + " = " +
                                  detail::call_text(*questions, reflect::value_name<Factory>(), all) + ";");
    }
    return object;
}

/// Says in code what is asked next, where it is no call of one function: a program's draw, a script of events. `code`
/// returns the text; it is called only if somebody wants it.
template <class Code>
void ask_in_words(Recorder& out, const Code& code)
{
    Questions* const questions = out.questions();
    if (questions == nullptr) {
        // What it leads to is called by the driver itself.
        if (out.passes_over("")) out.end_case();
        return;
    }
    questions->begin();
    if (questions->code_is_wanted()) questions->set_code(code());
}

}
