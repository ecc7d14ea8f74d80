#pragma once

#include <string_view>
#include <umbral/gl/forward.hpp>

/// Calls of the back end that no trace sees: questions about the state that a traced call meets. Private to
/// libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

/// The back end's function of that name. The function itself is only taken for its type. A context must be current.
template <class Function>
[[nodiscard]] Function* direct(Function*, std::string_view name)
{
    return reinterpret_cast<Function*>(entry_of(name));
}

[[nodiscard]] inline int integer(unsigned what)
{
    GLint value = 0;
    direct(&glGetIntegerv, "glGetIntegerv")(what, &value);
    return value;
}

#pragma GCC visibility pop

}
