#pragma once

#include <string_view>

namespace umbral::grader {

/// "GL_FILL" for 6914: the name of an enumerant that units meet; empty for other numbers. Modes of primitives, which
/// have the numbers of much else, are none.
[[nodiscard]] std::string_view gl_enumerant(double value);

/// The name of a value of OpenGL's state, GL_FILL for 6914 in a column called "GL_POLYGON_MODE front"; empty where the
/// column holds numbers of another kind, or the value has no name there.
[[nodiscard]] std::string_view gl_word(std::string_view column, double value);

}
