#include <algorithm>
#include <array>
#include <umbral/gl/effects.hpp>

namespace umbral::gl {
namespace {

using enum Effect;
using Kind = Size::Kind;

constexpr Size bytes(std::size_t size, std::size_t pointer) { return {Kind::bytes, size, pointer, 0, 0}; }
constexpr Size picture(std::size_t extent, std::size_t dimensions, std::size_t pointer)
{
    return {Kind::picture, extent, pointer, dimensions, 0};
}
constexpr Size items(std::size_t count, std::size_t pointer, std::size_t item)
{
    return {Kind::items, count, pointer, 0, item};
}
constexpr Size uniforms(std::size_t count) { return {Kind::uniforms, count, 0, 0, 0}; }

/// The first rule that matches counts.
constexpr std::array rules = {
    // Buffers.
    FunctionRule{"glBufferData glNamedBufferData glBufferStorage glNamedBufferStorage", uploads, bytes(1, 2)},
    FunctionRule{"glBufferSubData glNamedBufferSubData", uploads, bytes(2, 3)},
    FunctionRule{"glClearBufferData glClearNamedBufferData", uploads, picture(0, 0, 4)},
    FunctionRule{"glClearBufferSubData glClearNamedBufferSubData", uploads, picture(0, 0, 6)},
    FunctionRule{"glMapBuffer glMapNamedBuffer glMapBufferRange glMapNamedBufferRange glUnmapBuffer glUnmapNamedBuffer "
                 "glFlushMappedBufferRange "
                 "glFlushMappedNamedBufferRange",
                 maps},

    // Textures and pictures.
    FunctionRule{"glTexImage1D", uploads, picture(3, 1, 7)}, FunctionRule{"glTexImage2D", uploads, picture(3, 2, 8)},
    FunctionRule{"glTexImage3D", uploads, picture(3, 3, 9)},
    FunctionRule{"glTexSubImage1D glTextureSubImage1D", uploads, picture(3, 1, 6)},
    FunctionRule{"glTexSubImage2D glTextureSubImage2D", uploads, picture(4, 2, 8)},
    FunctionRule{"glTexSubImage3D glTextureSubImage3D", uploads, picture(5, 3, 10)},
    FunctionRule{"glCompressedTexImage1D", uploads, bytes(5, 6)},
    FunctionRule{"glCompressedTexImage2D", uploads, bytes(6, 7)},
    FunctionRule{"glCompressedTexImage3D", uploads, bytes(7, 8)},
    FunctionRule{"glCompressedTexSubImage1D glCompressedTextureSubImage1D", uploads, bytes(5, 6)},
    FunctionRule{"glCompressedTexSubImage2D glCompressedTextureSubImage2D", uploads, bytes(7, 8)},
    FunctionRule{"glCompressedTexSubImage3D glCompressedTextureSubImage3D", uploads, bytes(9, 10)},
    FunctionRule{"glClearTexImage", uploads, picture(0, 0, 4)},
    FunctionRule{"glClearTexSubImage", uploads, picture(0, 0, 10)},
    FunctionRule{"glDrawPixels", uploads, picture(0, 2, 4)},
    FunctionRule{"glBitmap", uploads, {Kind::bits, 0, 6, 2, 0}},
    FunctionRule{"glPolygonStipple", uploads, {Kind::fixed, 0, 0, 0, 128}},
    FunctionRule{"glColorTable glConvolutionFilter1D", uploads, picture(2, 1, 5)},
    FunctionRule{"glColorSubTable", uploads, picture(2, 1, 5)},
    FunctionRule{"glConvolutionFilter2D glSeparableFilter2D", uploads, picture(2, 2, 6)},
    FunctionRule{"glPixelMapfv glPixelMapuiv", uploads, items(1, 2, 4)},
    FunctionRule{"glPixelMapusv", uploads, items(1, 2, 2)},

    // Evaluators: control points of four components at most.
    FunctionRule{"glMap1f", uploads, items(4, 5, 16)}, FunctionRule{"glMap1d", uploads, items(4, 5, 32)},
    FunctionRule{"glMap2f", uploads, {Kind::items, 4, 9, 8, 16}},
    FunctionRule{"glMap2d", uploads, {Kind::items, 4, 9, 8, 32}},

    // Programs and their inputs.
    FunctionRule{"glUniformSubroutinesuiv", parameters}, FunctionRule{"glUniform*v", array, uniforms(1)},
    FunctionRule{"glProgramUniform*v", array, uniforms(2)},
    FunctionRule{"glShaderSource glCreateShaderProgramv", program},
    FunctionRule{"glProgramBinary", uploads, bytes(3, 2)}, FunctionRule{"glShaderBinary", uploads, bytes(4, 3)},

    // Draws, and the memory that they read.
    FunctionRule{"glDrawBuffers glNamedFramebufferDrawBuffers", objects},
    FunctionRule{"glDrawBuffer glDrawTransformFeedback*", none},
    FunctionRule{
        "glDraw* glMultiDraw* glArrayElement glEvalMesh* glEvalPoint* glCallList glCallLists glDispatchCompute*",
        draws},
    FunctionRule{"glInterleavedArrays glVertexPointer glNormalPointer glColorPointer glSecondaryColorPointer "
                 "glTexCoordPointer glFogCoordPointer "
                 "glIndexPointer glEdgeFlagPointer glVertexAttribPointer glVertexAttribIPointer glVertexAttribLPointer",
                 points},
    FunctionRule{"glNewList glEndList glDeleteLists glListBase", lists},
    FunctionRule{"glSelectBuffer glFeedbackBuffer", reads_back},

    // A few numbers by a pointer.
    FunctionRule{"glVertex*v glColor*v glNormal*v glTexCoord*v glMultiTexCoord*v glSecondaryColor*v glFogCoord*v "
                 "glIndex*v glEdgeFlagv glRect*v "
                 "glRasterPos*v glWindowPos*v glVertexAttrib*v glEvalCoord*v",
                 parameters},
    FunctionRule{"glTex*Parameter*v glSamplerParameter*v glPointParameter*v glPatchParameter*v glColorTableParameter*v "
                 "glConvolutionParameter*v "
                 "glClearBuffer*v glClearNamedFramebuffer*v glViewport*v glScissor*v glDepthRange*v glTexGen*v "
                 "glTexEnv*v glLight*v glMaterial*v glFog*v "
                 "glClipPlane glLoadMatrix* glLoadTransposeMatrix* glMultMatrix* glMultTransposeMatrix*",
                 parameters},

    // Names of objects, and texts about them.
    FunctionRule{"glGen*s glCreate*s glDelete*s glBindBuffers* glBindTextures glBindSamplers glBindImageTextures "
                 "glBindVertexBuffers "
                 "glVertexArrayVertexBuffers glInvalidate*Framebuffer* glPrioritizeTextures glAreTexturesResident "
                 "glBindAttribLocation "
                 "glBindFragDataLocation* glTransformFeedbackVaryings glDebugMessage* glPushDebugGroup glObjectLabel "
                 "glObjectPtrLabel",
                 objects},
    FunctionRule{"glGet* glReadPixels glReadnPixels", reads_back}};

constexpr std::array<std::string_view, 16> vendor_suffixes = {"ARB",  "EXT",  "MESA",  "ATI", "NV",    "OES",
                                                              "SGIS", "SGIX", "INTEL", "AMD", "APPLE", "KHR",
                                                              "IBM",  "HP",   "SUN",   "OVR"};

std::string_view without_suffix(std::string_view function)
{
    for (const std::string_view suffix : vendor_suffixes)
        if (function.ends_with(suffix)) return function.substr(0, function.size() - suffix.size());
    return function;
}

/// A '*' in the pattern stands for any letters.
bool matches(std::string_view name, std::string_view pattern)
{
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return name == pattern;
    if (!name.starts_with(pattern.substr(0, star))) return false;
    for (std::size_t i = star; i <= name.size(); ++i)
        if (matches(name.substr(i), pattern.substr(star + 1))) return true;
    return false;
}

}

const FunctionRule* rule_of(std::string_view function)
{
    const std::string_view name = without_suffix(function);
    for (const FunctionRule& rule : rules)
        for (std::string_view rest = rule.names; !rest.empty();) {
            const std::string_view pattern = rest.substr(0, rest.find(' '));
            if (matches(name, pattern)) return &rule;
            rest.remove_prefix(std::min(pattern.size() + 1, rest.size()));
        }
    return nullptr;
}

Effect effect_of(std::string_view function)
{
    const FunctionRule* rule = rule_of(function);
    return rule == nullptr ? Effect::none : rule->effect;
}

bool is_always_seen(std::string_view function)
{
    const Effect effect = effect_of(function);
    // Memory can be pinned by glBufferData, and stays the application's.
    return effect == Effect::maps || effect == Effect::lists || function == "glBufferData" ||
           function == "glBufferStorage";
}

}
