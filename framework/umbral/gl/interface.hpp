#pragma once

#include <string>
#include <vector>

namespace umbral::gl {

/// One attribute or uniform of a program.
struct Variable {
    std::string name;   ///< without "[0]"
    unsigned type = 0;  ///< GL_FLOAT_VEC3, …
    int count = 1;      ///< elements of an array; OpenGL may report fewer than declared: up to the last one used
    friend bool operator==(const Variable&, const Variable&) = default;
};

/// What goes into a program from outside.
struct Interface {
    std::vector<Variable> attributes;
    std::vector<Variable> uniforms;
};

/// The GLSL name of a type: "vec3" for GL_FLOAT_VEC3. Types beyond those of GLSL 3.30 come as their number.
[[nodiscard]] std::string type_name(unsigned type);

/// "vec3 light_color[8]": a variable as GLSL declares it.
[[nodiscard]] std::string declaration(const Variable& variable);

/// What is wrong with `actual`, one sentence for each variable: another type, an array that is too long, a name that
/// nobody feeds. A variable that is missing is no mismatch, because compilers remove what a program does not use.
[[nodiscard]] std::vector<std::string> mismatches(const Interface& expected, const Interface& actual);

/// Names in `expected` that `actual` lacks: never declared, or never used.
[[nodiscard]] std::vector<std::string> missing_names(const Interface& expected, const Interface& actual);

}
