#pragma once

#include <string>
#include <string_view>
#include <umbral/record/ask.hpp>
#include <vector>

/// Questions to a program that the driver runs by itself, such as shaders, whose inputs have names.
namespace umbral {
namespace detail {

/// Calls visit(name, value) for each input. A type whose fields are not called as the inputs are, or lie deeper, has a
/// function for_each_input(inputs, visit) in its namespace; of others, plain structs, the fields are the inputs.
template <class Inputs, class Visit>
void visit_inputs(Inputs& inputs, const Visit& visit)
{
    if constexpr (requires { for_each_input(inputs, visit); })
        for_each_input(inputs, visit);
    else
        reflect::for_each_field(inputs, visit);
}

template <class Inputs>
std::vector<Part> parts_of_inputs(Inputs& inputs)
{
    std::vector<Part> parts;
    visit_inputs(
        inputs, [&](std::string_view name, auto& field) { add_parts(Place{Place::no_argument} / name, field, parts); });
    return parts;
}

}

/// What a program that the driver runs by itself is fed with, each with its name (detail::visit_inputs): a shader's
/// uniforms and attributes. Returns what it is to be run with: others if another question is
/// asked in place of this one. The program is called `name` in sentences, such as "the shaders". The question itself
/// begins with ask_inputs, so that many can be run at once before.
template <class Inputs>
[[nodiscard]] Inputs inputs_asked(Recorder& out, std::string_view name, Inputs inputs)
{
    Questions* const questions = out.questions();
    if (questions != nullptr && questions->asks_instead_of(name))
        questions->change(name, detail::parts_of_inputs(inputs));
    return inputs;
}

/// "name = value", as what a shader is given is written in questions.
template <class Value>
std::string uniform_line(std::string_view name, const Value& value)
{
    return std::string(name) + " = " + literal::of_value(value, true, {}) + "\n";
}

/// ask_in_words for such a program, in a line for each input below `heading`: it is known, too, what its inputs are,
/// and what could be asked in their place.
template <class Inputs>
void ask_inputs(Recorder& out, std::string_view name, Inputs inputs, std::string_view heading)
{
    ask_in_words(out, [&] {
        std::string text(heading);
        detail::visit_inputs(inputs,
                             [&](std::string_view field, const auto& value) { text += uniform_line(field, value); });
        return text;
    });
    Questions* const questions = out.questions();
    if (questions == nullptr) return;
    const auto add_to = [&](Features& features) {
        detail::visit_inputs(inputs, [&](std::string_view field, const auto& value) {
            add_features(Place{Place::no_argument} / field, value, features);
        });
    };
    detail::note(*questions, name, add_to, [&] { return detail::parts_of_inputs(inputs); });
}

}
