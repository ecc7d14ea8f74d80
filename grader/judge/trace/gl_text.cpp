#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/rows/tensor_view.hpp"
#include "judge/trace/gl_calls.hpp"

// Of OpenGL's headers only numbers are used: the grader calls no function of it.
namespace umbral::grader {
namespace {

/// What the arguments of a function are, a letter each: m a primitive mode, e another enumerant, b a boolean, o the
/// number of an object, p a pointer or offset, n a number.
struct Signature {
    std::string_view name;
    std::string_view kinds;
};
constexpr std::array signatures{Signature{"glDrawArrays", "mnn"},
                                Signature{"glDrawElements", "mnep"},
                                Signature{"glDrawRangeElements", "mnnnep"},
                                Signature{"glDrawArraysInstanced", "mnnn"},
                                Signature{"glDrawElementsInstanced", "mnepn"},
                                Signature{"glDrawElementsBaseVertex", "mnepn"},
                                Signature{"glMultiDrawArrays", "mppn"},
                                Signature{"glMultiDrawElements", "mpepn"},
                                Signature{"glBegin", "m"},
                                Signature{"glCallList", "o"},
                                Signature{"glNewList", "oe"},
                                Signature{"glBindBuffer", "eo"},
                                Signature{"glBindBufferBase", "eno"},
                                Signature{"glBindVertexArray", "o"},
                                Signature{"glBindTexture", "eo"},
                                Signature{"glBindTextureUnit", "no"},
                                Signature{"glBindFramebuffer", "eo"},
                                Signature{"glBindRenderbuffer", "eo"},
                                Signature{"glBindSampler", "no"},
                                Signature{"glUseProgram", "o"},
                                Signature{"glDeleteProgram", "o"},
                                Signature{"glDeleteShader", "o"},
                                Signature{"glBufferData", "enpe"},
                                Signature{"glBufferSubData", "ennp"},
                                Signature{"glBufferStorage", "enpn"},
                                Signature{"glNamedBufferData", "onpe"},
                                Signature{"glNamedBufferSubData", "onnp"},
                                Signature{"glVertexAttribPointer", "nnebnp"},
                                Signature{"glVertexAttribIPointer", "nnenp"},
                                Signature{"glVertexPointer", "nenp"},
                                Signature{"glColorPointer", "nenp"},
                                Signature{"glNormalPointer", "enp"},
                                Signature{"glTexCoordPointer", "nenp"},
                                Signature{"glEnable", "e"},
                                Signature{"glDisable", "e"},
                                Signature{"glEnableClientState", "e"},
                                Signature{"glDisableClientState", "e"},
                                Signature{"glEnableVertexArrayAttrib", "on"},
                                Signature{"glDisableVertexArrayAttrib", "on"},
                                Signature{"glTexImage2D", "enennneep"},
                                Signature{"glTexSubImage2D", "ennnnneep"},
                                Signature{"glTexParameteri", "eee"},
                                Signature{"glActiveTexture", "e"},
                                Signature{"glCullFace", "e"},
                                Signature{"glFrontFace", "e"},
                                Signature{"glDepthFunc", "e"},
                                Signature{"glDepthMask", "b"},
                                Signature{"glPolygonMode", "ee"},
                                Signature{"glShadeModel", "e"},
                                Signature{"glMatrixMode", "e"},
                                Signature{"glPixelStorei", "en"},
                                Signature{"glGenBuffers", "np"},
                                Signature{"glGenVertexArrays", "np"},
                                Signature{"glGenTextures", "np"},
                                Signature{"glCreateBuffers", "np"},
                                Signature{"glCreateVertexArrays", "np"},
                                Signature{"glDeleteBuffers", "np"},
                                Signature{"glDeleteVertexArrays", "np"},
                                Signature{"glDeleteTextures", "np"},
                                Signature{"glCreateShader", "e"}};

constexpr std::array<const char*, 15> modes{"GL_POINTS",
                                            "GL_LINES",
                                            "GL_LINE_LOOP",
                                            "GL_LINE_STRIP",
                                            "GL_TRIANGLES",
                                            "GL_TRIANGLE_STRIP",
                                            "GL_TRIANGLE_FAN",
                                            "GL_QUADS",
                                            "GL_QUAD_STRIP",
                                            "GL_POLYGON",
                                            "GL_LINES_ADJACENCY",
                                            "GL_LINE_STRIP_ADJACENCY",
                                            "GL_TRIANGLES_ADJACENCY",
                                            "GL_TRIANGLE_STRIP_ADJACENCY",
                                            "GL_PATCHES"};

struct Enumerant {
    unsigned value;
    const char* name;
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
                                Enumerant{GL_FRAGMENT_SHADER, "GL_FRAGMENT_SHADER"}};

char kind_of(const GlCall& call, std::size_t index)
{
    const auto found = std::ranges::find(signatures, call.name, &Signature::name);
    return found != signatures.end() && index < found->kinds.size() ? found->kinds[index] : 'n';
}

std::string plain(double value)
{
    constexpr double exact = 9007199254740992.0;
    return value == std::trunc(value) && std::abs(value) < exact ? fmt::format("{:.0f}", value) : number_text(value);
}

std::string argument_text(char kind, double value)
{
    if (kind == 'p' && value == some_address) return "pointer";
    if (kind == 'b' && (value == 0 || value == 1)) return value == 0 ? "GL_FALSE" : "GL_TRUE";
    if (kind == 'm')
        for (std::size_t i = 0; i < modes.size(); ++i)
            if (value == static_cast<double>(i)) return modes[i];
    if (kind == 'e')
        for (const Enumerant& one : enumerants)
            if (value == static_cast<double>(one.value)) return one.name;
    return plain(value);
}

}

std::string in_cpp(const GlCall& call)
{
    std::string text = std::string(call.name) + "(";
    for (std::size_t i = 0; i < call.arguments.size(); ++i)
        text += (i == 0 ? "" : ", ") + argument_text(kind_of(call, i), call.arguments[i]);
    return text + ")";
}

bool same_call(const GlCall& a, const GlCall& b)
{
    if (a.name != b.name || a.arguments.size() != b.arguments.size() || a.bytes != b.bytes) return false;
    for (std::size_t i = 0; i < a.arguments.size(); ++i) {
        const char kind = kind_of(a, i);
        if (kind == 'o' || kind == 'p' ? (a.arguments[i] == 0) != (b.arguments[i] == 0)
                                       : a.arguments[i] != b.arguments[i])
            return false;
    }
    return true;
}

}
