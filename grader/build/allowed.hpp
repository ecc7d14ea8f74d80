#pragma once

#include <set>
#include <string>
#include <string_view>

namespace umbral::grader {

/// May a student's library want this symbol (mangled) from outside: the C++ library, mathematics, listed C functions,
/// OpenGL if `with_gl`, GLFW if `with_glfw`? What the framework and the unit's `uses` define is allowed beside it, by
/// the caller.
[[nodiscard]] bool is_allowed_symbol(std::string_view name, bool with_gl, bool with_glfw);

}
