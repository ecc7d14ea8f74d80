#pragma once

#include <array>
#include <string>
#include <umbral/pipeline/program.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Shaders that the drivers hand to the student's class.
namespace umbral::pipeline {

/// The uniform of type float: its name does not fit into 64 bytes.
inline const char* const long_name = "number_of_lamps_in_the_whole_of_the_great_hall_of_the_old_palace";

/// A right pair, with one uniform of each type that can be set; one of them in an array, one in a structure.
inline ShaderTexts uniforms_of_all_types()
{
    return {R"(#version 330
in vec3 position;
uniform mat4 matrix4;
uniform mat3 matrix3;
uniform struct { vec4 vector4; } lamp;
out vec3 shade;
void main()
{
    gl_Position = matrix4 * vec4(position, 1.0) + lamp.vector4;
    shade = matrix3 * position;
}
)",
            R"(#version 330
in vec3 shade;
uniform vec3 vectors[3];
uniform float number_of_lamps_in_the_whole_of_the_great_hall_of_the_old_palace;
uniform int whole;
out vec4 pixel;
void main()
{
    float lamps = number_of_lamps_in_the_whole_of_the_great_hall_of_the_old_palace;
    pixel = vec4(shade + (vectors[0] + vectors[1] + vectors[2]) * lamps, float(whole));
}
)"};
}

/// The same uniforms in other places, among others.
inline ShaderTexts uniforms_elsewhere()
{
    return {R"(#version 330
in vec3 position;
uniform int whole;
uniform vec3 vectors[3];
uniform mat3 matrix3;
uniform struct { vec4 vector4; } lamp;
out vec3 shade;
void main()
{
    gl_Position = lamp.vector4;
    shade = matrix3 * position + vectors[whole % 3] + vectors[1];
}
)",
            R"(#version 330
in vec3 shade;
uniform sampler2D image;
uniform vec4 further;
uniform mat4 matrix4;
uniform float number_of_lamps_in_the_whole_of_the_great_hall_of_the_old_palace;
out vec4 pixel;
void main()
{
    vec4 place = vec4(shade, number_of_lamps_in_the_whole_of_the_great_hall_of_the_old_palace);
    pixel = matrix4 * place + texture(image, shade.xy) + further;
}
)"};
}

constexpr int uniform_types = 6;

/// The same uniforms again, of which the one of type `first`, 0 to 5, is declared first: OpenGL may number from there.
inline ShaderTexts uniforms_beginning_with(int first)
{
    const std::array<std::string, uniform_types> declared{"int whole",       std::string("float ") + long_name,
                                                          "vec3 vectors[3]", "struct { vec4 vector4; } lamp",
                                                          "mat3 matrix3",    "mat4 matrix4"};
    std::string vertex = "#version 330\nin vec3 position;\n";
    for (int i = 0; i < uniform_types; ++i)
        vertex += "uniform " + declared[static_cast<std::size_t>((first + i) % uniform_types)] + ";\n";
    vertex += std::string("void main()\n{\n    vec3 sum = vectors[0] + vectors[1] + vectors[2] + float(whole);\n") +
              "    gl_Position = matrix4 * vec4(matrix3 * position + sum, " + long_name + ") + lamp.vector4;\n}\n";
    return {vertex, "#version 330\nout vec4 pixel;\nvoid main() { pixel = vec4(1.0); }\n"};
}

/// Pairs that are right, but not plain: OpenGL warns of some, others cannot be drawn with before their samplers are
/// set, or have comments before their version, a long one too: 16 bits do not count its letters.
inline std::vector<ShaderTexts> right_texts()
{
    const std::string version = "#version 330\n";
    const std::string vertex = version + "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n";
    const std::string images =
        "uniform sampler2D flat_image;\nuniform samplerCube sky;\nout vec4 pixel;\nvec4 both() { return "
        "texture(flat_image, vec2(0.5)) + texture(sky, vec3(1.0)); }\n";
    return {
        {vertex, version + images + "void main()\n{\n    vec4 never_set;\n    pixel = both() + never_set;\n}\n"},
        {"// A comment.\n\n" + vertex, "/* Another one. */\n" + version + images + "void main() { pixel = both(); }\n"},
        {vertex, version + "out vec4 pixel;\nvoid main()\n{\n    vec4 never_set;\n    pixel = never_set;\n}\n"},
        {vertex,
         "// " + std::string(70'000, '-') + "\n" + version + "out vec4 pixel;\nvoid main() { pixel = vec4(1.0); }\n"},
        uniforms_elsewhere()};
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
        {"", good.fragment},
        {good.vertex, ""},
        {version + "void main() { gl_Position = vec4(first_mistake, 1.0); }\n",
         version + "out vec4 pixel;\nvoid main() { pixel = vec4(second_mistake); }\n"},
        {version + "void main() { gl_Position = 1.0; }\n", "#version 330\nvoid main() { undeclared(); }\n"},
        {good.vertex, version + "in float shade;\nout vec4 pixel;\nvoid main() { pixel = vec4(shade); }\n"},
        {version + "void helper() {}\n", good.fragment},
        // OpenGL warns of the fragment shader, too: that is not what the link says.
        {good.vertex, version + "in vec2 shade;\nout vec4 pixel;\nvoid main()\n{\n    vec4 never_set;\n    pixel = "
                                "never_set + vec4(shade, 0.0, 1.0);\n}\n"},
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

/// The texts some lines further down, so that their logs name other lines. As written unless inputs are to vary.
inline ShaderTexts varied(Variation& vary, ShaderTexts texts)
{
    if (Random* const random = vary.random())
        for (std::string* const text : {&texts.vertex, &texts.fragment}) text->insert(0, 1 + random->below(900), '\n');
    return texts;
}

}
