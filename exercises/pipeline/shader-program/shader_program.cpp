#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/program.hpp>

namespace umbral::pipeline {

// A class of your own that derives from ShaderProgram goes here. Keep in it the name of the program object.

std::unique_ptr<ShaderProgram> make_shader_program(const ShaderTexts& texts)
{
    // TODO: for each text glCreateShader, glShaderSource, glCompileShader, and GL_COMPILE_STATUS; then glCreateProgram,
    // glAttachShader, glLinkProgram, and GL_LINK_STATUS. What fails throws a ShaderError with the log; nothing may be
    // left over, neither then nor else.
    return not_implemented<std::unique_ptr<ShaderProgram>>(texts);
}

ShaderTexts minimal_shaders()
{
    // TODO: two texts in GLSL; R"glsl(#version 330 ... )glsl" is a literal of several lines. The header says what they
    // are fed with.
    return not_implemented<ShaderTexts>();
}

ShaderTexts lit_shaders()
{
    // TODO: the same with normals, light and texture, and a switch for each.
    return not_implemented<ShaderTexts>();
}

}
