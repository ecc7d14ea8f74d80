#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <umbral/gl/opengl.hpp>

/// What the generated forwarders are made of. Private to libumbral-gl: nothing here is exported.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

using Entry = void (*)();

extern const std::size_t entry_count;
extern const char* const entry_names[];
extern Entry entries[];  ///< addresses in the back end; all null while no context is current
extern bool tracing;

[[noreturn]] void no_context(std::size_t slot);
void trace_call(std::size_t slot, std::span<const double> arguments);

#pragma GCC visibility pop

/// An argument as a trace keeps it: numbers as they are, pointers as 0 (null) or 1.
template <class Argument>
double as_number(Argument argument)
{
    if constexpr (std::is_pointer_v<Argument>)
        return argument == nullptr ? 0 : 1;
    else
        return static_cast<double>(argument);
}

/// Passes a call on to the back end. The function itself is only taken for its type.
template <class Result, class... Arguments>
Result forward(Result (*)(Arguments...), std::size_t slot, std::type_identity_t<Arguments>... arguments)
{
    const Entry entry = entries[slot];
    if (entry == nullptr) [[unlikely]]
        no_context(slot);
    if (tracing) [[unlikely]] {
        const double numbers[] = {as_number(arguments)..., 0};
        trace_call(slot, std::span(numbers, sizeof...(arguments)));
    }
    return reinterpret_cast<Result (*)(Arguments...)>(entry)(arguments...);
}

}
