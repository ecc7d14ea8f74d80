#pragma once

#include <array>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/gl/opengl.hpp>
#include <vector>

#include "support_gl.hpp"

/// State that no drawing has to touch: what it was before, it must be afterwards.
namespace umbral::pipeline {

struct Watched {
    GLenum name;
    const char* text;
};

inline constexpr std::array watched_state = {
    Watched{GL_CURRENT_PROGRAM, "GL_CURRENT_PROGRAM"},
    Watched{GL_ACTIVE_TEXTURE, "GL_ACTIVE_TEXTURE"},
    Watched{GL_DEPTH_WRITEMASK, "GL_DEPTH_WRITEMASK"},
    Watched{GL_STENCIL_WRITEMASK, "GL_STENCIL_WRITEMASK"},
    Watched{GL_CULL_FACE, "GL_CULL_FACE"},
    Watched{GL_CULL_FACE_MODE, "GL_CULL_FACE_MODE"},
    Watched{GL_FRONT_FACE, "GL_FRONT_FACE"},
    Watched{GL_BLEND, "GL_BLEND"},
    Watched{GL_DITHER, "GL_DITHER"},
    Watched{GL_MULTISAMPLE, "GL_MULTISAMPLE"},
    Watched{GL_SCISSOR_TEST, "GL_SCISSOR_TEST"},
    Watched{GL_STENCIL_TEST, "GL_STENCIL_TEST"},
    Watched{GL_COLOR_LOGIC_OP, "GL_COLOR_LOGIC_OP"},
    Watched{GL_FRAMEBUFFER_SRGB, "GL_FRAMEBUFFER_SRGB"},
    Watched{GL_RASTERIZER_DISCARD, "GL_RASTERIZER_DISCARD"},
    Watched{GL_PRIMITIVE_RESTART, "GL_PRIMITIVE_RESTART"},
    Watched{GL_PRIMITIVE_RESTART_FIXED_INDEX, "GL_PRIMITIVE_RESTART_FIXED_INDEX"},
    Watched{GL_PRIMITIVE_RESTART_INDEX, "GL_PRIMITIVE_RESTART_INDEX"},
    Watched{GL_POLYGON_OFFSET_FILL, "GL_POLYGON_OFFSET_FILL"},
    Watched{GL_POLYGON_OFFSET_LINE, "GL_POLYGON_OFFSET_LINE"},
    Watched{GL_POLYGON_OFFSET_POINT, "GL_POLYGON_OFFSET_POINT"},
    Watched{GL_LINE_SMOOTH, "GL_LINE_SMOOTH"},
    Watched{GL_LINE_STIPPLE, "GL_LINE_STIPPLE"},
    Watched{GL_POLYGON_SMOOTH, "GL_POLYGON_SMOOTH"},
    Watched{GL_POLYGON_STIPPLE, "GL_POLYGON_STIPPLE"},
    Watched{GL_POINT_SIZE, "GL_POINT_SIZE"},
    Watched{GL_SHADE_MODEL, "GL_SHADE_MODEL"},
    Watched{GL_PROVOKING_VERTEX, "GL_PROVOKING_VERTEX"},
    Watched{GL_LIGHTING, "GL_LIGHTING"},
    Watched{GL_TEXTURE_2D, "GL_TEXTURE_2D"},
    Watched{GL_MATRIX_MODE, "GL_MATRIX_MODE"},
    Watched{GL_ATTRIB_STACK_DEPTH, "GL_ATTRIB_STACK_DEPTH"},
    Watched{GL_CLIENT_ATTRIB_STACK_DEPTH, "GL_CLIENT_ATTRIB_STACK_DEPTH"},
    Watched{GL_UNPACK_ALIGNMENT, "GL_UNPACK_ALIGNMENT"},
    Watched{GL_UNPACK_ROW_LENGTH, "GL_UNPACK_ROW_LENGTH"},
    Watched{GL_PIXEL_UNPACK_BUFFER_BINDING, "GL_PIXEL_UNPACK_BUFFER_BINDING"},
    Watched{GL_COPY_READ_BUFFER_BINDING, "GL_COPY_READ_BUFFER_BINDING"},
    Watched{GL_COPY_WRITE_BUFFER_BINDING, "GL_COPY_WRITE_BUFFER_BINDING"},
    Watched{GL_UNIFORM_BUFFER_BINDING, "GL_UNIFORM_BUFFER_BINDING"},
};

inline void append_watched(std::vector<float>& row)
{
    for (const Watched& watched : watched_state) row.push_back(state_of(watched.name));
    std::array<GLfloat, 2> depths{};
    glGetFloatv(GL_DEPTH_RANGE, depths.data());
    row.insert(row.end(), depths.begin(), depths.end());
}

/// What append_watched's numbers are called, for Recorder::columns.
inline std::string watched_columns()
{
    std::string names;
    for (const Watched& watched : watched_state) names += std::string(watched.text) + ", ";
    return names + "GL_DEPTH_RANGE near, GL_DEPTH_RANGE far";
}

/// Others than the initial values, of state that shows in no picture of triangles and lines, and for which the software
/// renderer need not compile its shaders anew.
inline void choose_watched(Random& random)
{
    glActiveTexture(GL_TEXTURE0 + random.below(8));
    glStencilMask(1 + random.below(255));
    glCullFace(random.below(2) == 0 ? GL_FRONT : GL_BACK);
    glPrimitiveRestartIndex(1 + random.below(1000));
    glPointSize(static_cast<float>(1 + random.below(9)));
    random.below(2) == 0 ? glEnable(GL_POLYGON_OFFSET_POINT) : glDisable(GL_POLYGON_OFFSET_POINT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1 << random.below(4));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(random.below(50)));
}

}
