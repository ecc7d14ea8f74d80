#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/rows/gl_words.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/trace/gl_calls.hpp"

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
        if (const std::string_view name = gl_enumerant(value); !name.empty()) return std::string(name);
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
