#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <umbral/gl/opengl.hpp>

/// What the generated forwarders are made of. Private to libumbral-gl: nothing here is exported.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

using Entry = void (*)();

/// The arguments of a call: numbers as as_number gives them, and beside each the address if it is a pointer to
/// something (else null).
struct CallArguments {
    std::span<const double> numbers;
    std::span<const void* const> pointers;

    [[nodiscard]] double number(std::size_t i) const { return i < numbers.size() ? numbers[i] : 0; }
    [[nodiscard]] unsigned name(std::size_t i) const { return static_cast<unsigned>(number(i)); }
    [[nodiscard]] const void* pointer(std::size_t i) const { return i < pointers.size() ? pointers[i] : nullptr; }
};

extern const std::size_t entry_count;
extern const char* const entry_names[];
extern Entry entries[];  ///< addresses in the back end; all null while no context is current
extern bool watching;    ///< a trace is running, or a display list is being made

/// The back end's function of that name, past all traces; null if no context is current or there is none.
[[nodiscard]] Entry entry_of(std::string_view name);

[[noreturn]] void no_context(std::size_t slot);
void trace_call(std::size_t slot, const CallArguments& arguments);

#pragma GCC visibility pop

/// An argument as a trace keeps it: numbers as they are; offsets into buffers, which are passed as pointers, too; and 1
/// for an address, which differs from run to run. No program has anything in the first 64 KiB.
template <class Argument>
double as_number(Argument argument)
{
    if constexpr (std::is_pointer_v<Argument>) {
        const auto place = reinterpret_cast<std::uintptr_t>(argument);
        return place < 0x10000 ? static_cast<double>(place) : 1;
    } else {
        return static_cast<double>(argument);
    }
}

template <class Argument>
const void* as_pointer(Argument argument)
{
    if constexpr (std::is_pointer_v<Argument> && !std::is_function_v<std::remove_pointer_t<Argument>>)
        return argument;
    else
        return nullptr;
}

/// Passes a call on to the back end. The function itself is only taken for its type. `always`: it is seen even if
/// nothing is watched.
template <bool always = false, class Result, class... Arguments>
Result forward(Result (*)(Arguments...), std::size_t slot, std::type_identity_t<Arguments>... arguments)
{
    const Entry entry = entries[slot];
    if (entry == nullptr) [[unlikely]]
        no_context(slot);
    if (always || watching) [[unlikely]] {
        const double numbers[] = {as_number(arguments)..., 0};
        const void* const pointers[] = {as_pointer(arguments)..., nullptr};
        trace_call(slot, {std::span(numbers, sizeof...(arguments)), std::span(pointers, sizeof...(arguments))});
    }
    return reinterpret_cast<Result (*)(Arguments...)>(entry)(arguments...);
}

}
