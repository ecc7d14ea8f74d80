#pragma once

#include <string>
#include <string_view>

namespace umbral::grader {

/// May a student's library want this symbol (mangled) from outside: the C++ library, mathematics, harmless C functions
/// (c_functions.hpp), OpenGL if `with_gl`, GLFW if `with_glfw`? What the framework and the unit's `uses` define is
/// allowed beside it, by the caller.
[[nodiscard]] bool is_allowed_symbol(std::string_view name, bool with_gl, bool with_glfw);

/// What a symbol that is not allowed does, as far as it is known: "opens or changes files, or asks about them".
[[nodiscard]] std::string_view what_is_wrong_with(std::string_view name);

}
