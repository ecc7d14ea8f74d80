#pragma once

#include <string>
#include <umbral/pipeline/program.hpp>
#include <vector>

/// Shaders that the drivers hand to the student's class.
namespace umbral::pipeline {

/// A right pair, with one uniform of each type that can be set.
inline ShaderTexts uniforms_of_all_types()
{
    return {R"(#version 330
in vec3 position;
uniform mat4 matrix4;
uniform mat3 matrix3;
uniform vec4 vector4;
out vec3 shade;
void main()
{
    gl_Position = matrix4 * vec4(position, 1.0) + vector4;
    shade = matrix3 * position;
}
)",
            R"(#version 330
in vec3 shade;
uniform vec3 vector3;
uniform float number;
uniform int whole;
out vec4 pixel;
void main() { pixel = vec4(shade + vector3 * number, float(whole)); }
)"};
}

/// Pairs that fail, at one step or at several: then the first one counts.
inline std::vector<ShaderTexts> failing_texts()
{
    const ShaderTexts good = uniforms_of_all_types();
    const std::string version = "#version 330\n";
    return {
        {version + "void main() { gl_Position = vec4(nothing, 1.0); }\n", good.fragment},
        {version + "void main()\n{\n    gl_Position = vec4(0.0)\n}\n", good.fragment},
        // The course's own line: a matrix of four columns times a vector of three numbers.
        {version + "in vec3 normal;\nuniform mat4 turn;\nout vec3 n;\nvoid main()\n{\n    gl_Position = vec4(0.0);\n   "
                   " n = turn * normal;\n}\n",
         good.fragment},
        {good.vertex, version + "out vec4 pixel;\nvoid main()\n{\n    pixel = vec3(1.0, 0.0, 0.0);\n}\n"},
        {good.vertex, "#version 330\nout vec4 pixel;\n\n\nvoid main() { pixel = color; undeclared(); }\n"},
        {"nonsense", "more nonsense"},
        {good.vertex, version + "in float shade;\nout vec4 pixel;\nvoid main() { pixel = vec4(shade); }\n"},
        {version + "void helper() {}\n", good.fragment},
        {good.vertex, version + "uniform mat3 matrix4;\nin vec3 shade;\nout vec4 pixel;\nvoid main() { pixel = "
                                "vec4(matrix4 * shade, 1.0); }\n"},
    };
}

/// A fragment shader with that many mistakes: its log holds a line or two for each.
inline ShaderTexts with_many_errors(int count)
{
    ShaderTexts texts = uniforms_of_all_types();
    texts.fragment = "#version 330\nout vec4 pixel;\nvoid main()\n{\n    pixel = vec4(0.0);\n";
    for (int i = 0; i < count; ++i)
        texts.fragment += "    pixel.r += a_name_that_nobody_has_declared_" + std::to_string(i) + ";\n";
    texts.fragment += "}\n";
    return texts;
}

}
