#include "judge/trace/gl_calls.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace umbral::grader {
namespace {

constexpr std::size_t most_calls = 65536;
constexpr std::size_t most_arguments = 32;
constexpr std::size_t longest_name = 64;
constexpr std::string_view left_out = "...";

std::string_view take(std::string_view& text, char separator)
{
    const std::string_view part = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
}

template <class Number>
bool read(std::string_view text, Number& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

bool is_function_name(std::string_view name)
{
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    return name.size() > 2 && name.size() <= longest_name && name.starts_with("gl") && std::ranges::all_of(name, plain);
}

std::optional<GlCall> parse_call(std::string_view line)
{
    GlCall call;
    call.name = take(line, ' ');
    if (!is_function_name(call.name)) return std::nullopt;
    while (!line.empty()) {
        const std::string_view word = take(line, ' ');
        if (word == "|") {
            if (!read(line, call.bytes)) return std::nullopt;
            return call;
        }
        if (call.arguments.size() == most_arguments || !read(word, call.arguments.emplace_back())) return std::nullopt;
    }
    return call;
}

bool begins(std::string_view name, std::span<const std::string_view> beginnings)
{
    return std::ranges::any_of(beginnings, [&](std::string_view beginning) { return name.starts_with(beginning); });
}

/// An argument as a number of things: what is absent, negative or not finite counts as none.
double count(const GlCall& call, std::size_t index)
{
    constexpr double largest = 1e12;
    const double value = index < call.arguments.size() ? call.arguments[index] : 0;
    return value > 0 ? std::min(value, largest) : 0;
}

/// Where a draw call says how many vertices (and instances) it draws.
struct Counted {
    std::string_view name;
    std::size_t vertices;
    std::optional<std::size_t> instances = std::nullopt;
};
constexpr std::array counted_calls{Counted{"glDrawArrays", 2},
                                   Counted{"glDrawElements", 1},
                                   Counted{"glDrawRangeElements", 3},
                                   Counted{"glDrawElementsBaseVertex", 1},
                                   Counted{"glDrawRangeElementsBaseVertex", 3},
                                   Counted{"glDrawArraysInstanced", 2, 3},
                                   Counted{"glDrawArraysInstancedBaseInstance", 2, 3},
                                   Counted{"glDrawElementsInstanced", 1, 4},
                                   Counted{"glDrawElementsInstancedBaseVertex", 1, 4},
                                   Counted{"glDrawElementsInstancedBaseInstance", 1, 4},
                                   Counted{"glDrawElementsInstancedBaseVertexBaseInstance", 1, 4}};

constexpr std::string_view drawing[] = {"glDrawArrays",
                                        "glDrawElements",
                                        "glDrawRangeElements",
                                        "glDrawTransformFeedback",
                                        "glDrawPixels",
                                        "glMultiDraw",
                                        "glBegin",
                                        "glCallList",
                                        "glRect",
                                        "glBitmap",
                                        "glEvalMesh"};

constexpr std::string_view state[] = {"glEnable",
                                      "glDisable",
                                      "glBind",
                                      "glUse",
                                      "glActiveTexture",
                                      "glActiveShaderProgram",
                                      "glBlend",
                                      "glColorMask",
                                      "glCullFace",
                                      "glDepth",
                                      "glFrontFace",
                                      "glLineWidth",
                                      "glLogicOp",
                                      "glPixelStore",
                                      "glPointSize",
                                      "glPolygonMode",
                                      "glProvoking",
                                      "glPolygonOff",
                                      "glPrimitiveR",
                                      "glSampleCov",
                                      "glScissor",
                                      "glStencil",
                                      "glViewport",
                                      "glVertexAttribPointer",
                                      "glVertexAttribI",
                                      "glVertexAttribFormat",
                                      "glVertexAttribBinding",
                                      "glVertexAttribDivisor",
                                      "glVertexPointer",
                                      "glNormalPointer",
                                      "glColorPointer",
                                      "glTexCoordPointer",
                                      "glShadeModel",
                                      "glMatrixMode",
                                      "glAlphaFunc",
                                      "glLineStipple",
                                      "glPushAttrib",
                                      "glPopAttrib",
                                      "glPushClientAttrib",
                                      "glPopClientAttrib"};

}

std::optional<GlTrace> parse_gl_trace(std::string_view text)
{
    GlTrace trace;
    while (!text.empty()) {
        const std::string_view line = take(text, '\n');
        if (line == left_out && text.empty()) {
            trace.truncated = true;
            return trace;
        }
        if (trace.calls.size() == most_calls) return std::nullopt;
        auto call = parse_call(line);
        if (!call) return std::nullopt;
        trace.calls.push_back(std::move(*call));
    }
    return trace;
}

bool draws(const GlCall& call) { return begins(call.name, drawing); }

double vertices_of(const GlCall& call)
{
    constexpr std::string_view vertex[] = {"glVertex2",  "glVertex3",  "glVertex4",     "glVertexP2",
                                           "glVertexP3", "glVertexP4", "glArrayElement"};
    if (begins(call.name, vertex)) return 1;
    if (call.name.starts_with("glRect")) return 4;
    const auto found = std::ranges::find(counted_calls, call.name, &Counted::name);
    if (found == counted_calls.end()) return 0;
    return count(call, found->vertices) * (found->instances ? count(call, *found->instances) : 1);
}

std::optional<std::size_t> place_of_count(const GlCall& call)
{
    const auto found = std::ranges::find(counted_calls, call.name, &Counted::name);
    return found == counted_calls.end() ? std::nullopt : std::optional(found->vertices);
}

double objects_created(const GlCall& call)
{
    constexpr std::string_view single[] = {"glCreateShader", "glCreateProgram", "glFenceSync"};
    if (call.name == "glCreateTextures" || call.name == "glCreateQueries") return count(call, 1);
    if (call.name != "glCreateProgramPipelines" && begins(call.name, single)) return 1;
    if (call.name.starts_with("glGenerate")) return 0;
    return call.name.starts_with("glGen") || call.name.starts_with("glCreate") ? count(call, 0) : 0;
}

double objects_deleted(const GlCall& call)
{
    if (call.name == "glDeleteLists") return count(call, 1);
    if (call.name == "glDeleteShader" || call.name == "glDeleteProgram" || call.name == "glDeleteSync")
        return count(call, 0) > 0 ? 1 : 0;
    return call.name.starts_with("glDelete") ? count(call, 0) : 0;
}

bool changes_state(const GlCall& call)
{
    constexpr std::string_view at_linking[] = {"glBindAttribLocation", "glBindFragDataLocation"};
    return (begins(call.name, state) && !begins(call.name, at_linking)) || call.name.ends_with("State");
}

}
