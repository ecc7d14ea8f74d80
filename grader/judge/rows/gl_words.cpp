#include "judge/rows/gl_words.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>

// Of OpenGL's headers only numbers are used: the grader calls no function of it.
namespace umbral::grader {
namespace {

struct Enumerant {
    unsigned value;
    std::string_view name;
};
constexpr std::array enumerants{Enumerant{GL_BYTE, "GL_BYTE"},
                                Enumerant{GL_UNSIGNED_BYTE, "GL_UNSIGNED_BYTE"},
                                Enumerant{GL_SHORT, "GL_SHORT"},
                                Enumerant{GL_UNSIGNED_SHORT, "GL_UNSIGNED_SHORT"},
                                Enumerant{GL_INT, "GL_INT"},
                                Enumerant{GL_UNSIGNED_INT, "GL_UNSIGNED_INT"},
                                Enumerant{GL_FLOAT, "GL_FLOAT"},
                                Enumerant{GL_DOUBLE, "GL_DOUBLE"},
                                Enumerant{GL_ARRAY_BUFFER, "GL_ARRAY_BUFFER"},
                                Enumerant{GL_ELEMENT_ARRAY_BUFFER, "GL_ELEMENT_ARRAY_BUFFER"},
                                Enumerant{GL_UNIFORM_BUFFER, "GL_UNIFORM_BUFFER"},
                                Enumerant{GL_PIXEL_UNPACK_BUFFER, "GL_PIXEL_UNPACK_BUFFER"},
                                Enumerant{GL_STATIC_DRAW, "GL_STATIC_DRAW"},
                                Enumerant{GL_DYNAMIC_DRAW, "GL_DYNAMIC_DRAW"},
                                Enumerant{GL_STREAM_DRAW, "GL_STREAM_DRAW"},
                                Enumerant{GL_TEXTURE_1D, "GL_TEXTURE_1D"},
                                Enumerant{GL_TEXTURE_2D, "GL_TEXTURE_2D"},
                                Enumerant{GL_TEXTURE_3D, "GL_TEXTURE_3D"},
                                Enumerant{GL_TEXTURE_CUBE_MAP, "GL_TEXTURE_CUBE_MAP"},
                                Enumerant{GL_TEXTURE0, "GL_TEXTURE0"},
                                Enumerant{GL_TEXTURE_MIN_FILTER, "GL_TEXTURE_MIN_FILTER"},
                                Enumerant{GL_TEXTURE_MAG_FILTER, "GL_TEXTURE_MAG_FILTER"},
                                Enumerant{GL_TEXTURE_WRAP_S, "GL_TEXTURE_WRAP_S"},
                                Enumerant{GL_TEXTURE_WRAP_T, "GL_TEXTURE_WRAP_T"},
                                Enumerant{GL_NEAREST, "GL_NEAREST"},
                                Enumerant{GL_LINEAR, "GL_LINEAR"},
                                Enumerant{GL_LINEAR_MIPMAP_LINEAR, "GL_LINEAR_MIPMAP_LINEAR"},
                                Enumerant{GL_REPEAT, "GL_REPEAT"},
                                Enumerant{GL_CLAMP_TO_EDGE, "GL_CLAMP_TO_EDGE"},
                                Enumerant{GL_RED, "GL_RED"},
                                Enumerant{GL_RGB, "GL_RGB"},
                                Enumerant{GL_RGBA, "GL_RGBA"},
                                Enumerant{GL_RGB8, "GL_RGB8"},
                                Enumerant{GL_RGBA8, "GL_RGBA8"},
                                Enumerant{GL_SRGB8_ALPHA8, "GL_SRGB8_ALPHA8"},
                                Enumerant{GL_UNPACK_ALIGNMENT, "GL_UNPACK_ALIGNMENT"},
                                Enumerant{GL_FRAMEBUFFER, "GL_FRAMEBUFFER"},
                                Enumerant{GL_READ_FRAMEBUFFER, "GL_READ_FRAMEBUFFER"},
                                Enumerant{GL_DRAW_FRAMEBUFFER, "GL_DRAW_FRAMEBUFFER"},
                                Enumerant{GL_RENDERBUFFER, "GL_RENDERBUFFER"},
                                Enumerant{GL_BLEND, "GL_BLEND"},
                                Enumerant{GL_CULL_FACE, "GL_CULL_FACE"},
                                Enumerant{GL_DEPTH_TEST, "GL_DEPTH_TEST"},
                                Enumerant{GL_STENCIL_TEST, "GL_STENCIL_TEST"},
                                Enumerant{GL_SCISSOR_TEST, "GL_SCISSOR_TEST"},
                                Enumerant{GL_MULTISAMPLE, "GL_MULTISAMPLE"},
                                Enumerant{GL_PRIMITIVE_RESTART, "GL_PRIMITIVE_RESTART"},
                                Enumerant{GL_POLYGON_OFFSET_FILL, "GL_POLYGON_OFFSET_FILL"},
                                Enumerant{GL_LINE_SMOOTH, "GL_LINE_SMOOTH"},
                                Enumerant{GL_LIGHTING, "GL_LIGHTING"},
                                Enumerant{GL_VERTEX_ARRAY, "GL_VERTEX_ARRAY"},
                                Enumerant{GL_NORMAL_ARRAY, "GL_NORMAL_ARRAY"},
                                Enumerant{GL_COLOR_ARRAY, "GL_COLOR_ARRAY"},
                                Enumerant{GL_TEXTURE_COORD_ARRAY, "GL_TEXTURE_COORD_ARRAY"},
                                Enumerant{GL_FRONT, "GL_FRONT"},
                                Enumerant{GL_BACK, "GL_BACK"},
                                Enumerant{GL_FRONT_AND_BACK, "GL_FRONT_AND_BACK"},
                                Enumerant{GL_CW, "GL_CW"},
                                Enumerant{GL_CCW, "GL_CCW"},
                                Enumerant{GL_LESS, "GL_LESS"},
                                Enumerant{GL_LEQUAL, "GL_LEQUAL"},
                                Enumerant{GL_POINT, "GL_POINT"},
                                Enumerant{GL_LINE, "GL_LINE"},
                                Enumerant{GL_FILL, "GL_FILL"},
                                Enumerant{GL_FLAT, "GL_FLAT"},
                                Enumerant{GL_SMOOTH, "GL_SMOOTH"},
                                Enumerant{GL_MODELVIEW, "GL_MODELVIEW"},
                                Enumerant{GL_PROJECTION, "GL_PROJECTION"},
                                Enumerant{GL_COMPILE, "GL_COMPILE"},
                                Enumerant{GL_VERTEX_SHADER, "GL_VERTEX_SHADER"},
                                Enumerant{GL_FRAGMENT_SHADER, "GL_FRAGMENT_SHADER"},
                                Enumerant{GL_NEVER, "GL_NEVER"},
                                Enumerant{GL_EQUAL, "GL_EQUAL"},
                                Enumerant{GL_GREATER, "GL_GREATER"},
                                Enumerant{GL_NOTEQUAL, "GL_NOTEQUAL"},
                                Enumerant{GL_GEQUAL, "GL_GEQUAL"},
                                Enumerant{GL_ALWAYS, "GL_ALWAYS"},
                                Enumerant{GL_TEXTURE, "GL_TEXTURE"},
                                Enumerant{GL_MODULATE, "GL_MODULATE"},
                                Enumerant{GL_DECAL, "GL_DECAL"},
                                Enumerant{GL_REPLACE, "GL_REPLACE"},
                                Enumerant{GL_EYE_LINEAR, "GL_EYE_LINEAR"},
                                Enumerant{GL_OBJECT_LINEAR, "GL_OBJECT_LINEAR"},
                                Enumerant{GL_SPHERE_MAP, "GL_SPHERE_MAP"},
                                Enumerant{GL_CLAMP, "GL_CLAMP"},
                                Enumerant{GL_MIRRORED_REPEAT, "GL_MIRRORED_REPEAT"},
                                Enumerant{GL_NEAREST_MIPMAP_NEAREST, "GL_NEAREST_MIPMAP_NEAREST"},
                                Enumerant{GL_LINEAR_MIPMAP_NEAREST, "GL_LINEAR_MIPMAP_NEAREST"},
                                Enumerant{GL_NEAREST_MIPMAP_LINEAR, "GL_NEAREST_MIPMAP_LINEAR"},
                                Enumerant{GL_INVALID_ENUM, "GL_INVALID_ENUM"},
                                Enumerant{GL_INVALID_VALUE, "GL_INVALID_VALUE"},
                                Enumerant{GL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
                                Enumerant{GL_STACK_OVERFLOW, "GL_STACK_OVERFLOW"},
                                Enumerant{GL_STACK_UNDERFLOW, "GL_STACK_UNDERFLOW"},
                                Enumerant{GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY"},
                                Enumerant{GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"}};

/// How the names of columns begin that hold enumerants.
constexpr std::array<std::string_view, 12> states{"GL_POLYGON_MODE",       "GL_SHADE_MODEL",        "GL_FRONT_FACE",
                                                  "GL_CULL_FACE_MODE",     "GL_DEPTH_FUNC",         "GL_MATRIX_MODE",
                                                  "GL_TEXTURE_ENV_MODE",   "GL_TEXTURE_GEN_MODE",   "GL_TEXTURE_WRAP",
                                                  "GL_TEXTURE_MIN_FILTER", "GL_TEXTURE_MAG_FILTER", "glGetError"};

}

std::string_view gl_enumerant(double value)
{
    const auto* const found = std::ranges::find_if(
        enumerants, [value](const Enumerant& one) { return value == static_cast<double>(one.value); });
    return found == enumerants.end() ? std::string_view() : found->name;
}

std::string_view gl_word(std::string_view column, double value)
{
    const bool holds_them = std::ranges::any_of(states, [&](std::string_view one) { return column.starts_with(one); });
    return holds_them ? gl_enumerant(value) : std::string_view();
}

}
