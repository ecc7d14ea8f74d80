#include "judge/rows/gl_words.hpp"

#include <algorithm>
#include <array>

namespace umbral::grader {
namespace {

struct GlWord {
    std::string_view column;  ///< how the names of such columns begin
    int value;
    std::string_view word;
};

/// From the registry of OpenGL: the states that units look at.
constexpr std::array words{
    GlWord{"GL_POLYGON_MODE", 0x1B00, "GL_POINT"},
    GlWord{"GL_POLYGON_MODE", 0x1B01, "GL_LINE"},
    GlWord{"GL_POLYGON_MODE", 0x1B02, "GL_FILL"},
    GlWord{"GL_SHADE_MODEL", 0x1D00, "GL_FLAT"},
    GlWord{"GL_SHADE_MODEL", 0x1D01, "GL_SMOOTH"},
    GlWord{"GL_FRONT_FACE", 0x0900, "GL_CW"},
    GlWord{"GL_FRONT_FACE", 0x0901, "GL_CCW"},
    GlWord{"GL_CULL_FACE_MODE", 0x0404, "GL_FRONT"},
    GlWord{"GL_CULL_FACE_MODE", 0x0405, "GL_BACK"},
    GlWord{"GL_CULL_FACE_MODE", 0x0408, "GL_FRONT_AND_BACK"},
    GlWord{"GL_DEPTH_FUNC", 0x0200, "GL_NEVER"},
    GlWord{"GL_DEPTH_FUNC", 0x0201, "GL_LESS"},
    GlWord{"GL_DEPTH_FUNC", 0x0202, "GL_EQUAL"},
    GlWord{"GL_DEPTH_FUNC", 0x0203, "GL_LEQUAL"},
    GlWord{"GL_DEPTH_FUNC", 0x0204, "GL_GREATER"},
    GlWord{"GL_DEPTH_FUNC", 0x0205, "GL_NOTEQUAL"},
    GlWord{"GL_DEPTH_FUNC", 0x0206, "GL_GEQUAL"},
    GlWord{"GL_DEPTH_FUNC", 0x0207, "GL_ALWAYS"},
    GlWord{"GL_MATRIX_MODE", 0x1700, "GL_MODELVIEW"},
    GlWord{"GL_MATRIX_MODE", 0x1701, "GL_PROJECTION"},
    GlWord{"GL_MATRIX_MODE", 0x1702, "GL_TEXTURE"},
    GlWord{"GL_TEXTURE_ENV_MODE", 0x2100, "GL_MODULATE"},
    GlWord{"GL_TEXTURE_ENV_MODE", 0x2101, "GL_DECAL"},
    GlWord{"GL_TEXTURE_ENV_MODE", 0x1E01, "GL_REPLACE"},
    GlWord{"GL_TEXTURE_GEN_MODE", 0x2400, "GL_EYE_LINEAR"},
    GlWord{"GL_TEXTURE_GEN_MODE", 0x2401, "GL_OBJECT_LINEAR"},
    GlWord{"GL_TEXTURE_GEN_MODE", 0x2402, "GL_SPHERE_MAP"},
    GlWord{"GL_TEXTURE_WRAP", 0x2900, "GL_CLAMP"},
    GlWord{"GL_TEXTURE_WRAP", 0x2901, "GL_REPEAT"},
    GlWord{"GL_TEXTURE_WRAP", 0x812F, "GL_CLAMP_TO_EDGE"},
    GlWord{"GL_TEXTURE_WRAP", 0x8370, "GL_MIRRORED_REPEAT"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2600, "GL_NEAREST"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2601, "GL_LINEAR"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2700, "GL_NEAREST_MIPMAP_NEAREST"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2701, "GL_LINEAR_MIPMAP_NEAREST"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2702, "GL_NEAREST_MIPMAP_LINEAR"},
    GlWord{"GL_TEXTURE_MIN_FILTER", 0x2703, "GL_LINEAR_MIPMAP_LINEAR"},
    GlWord{"GL_TEXTURE_MAG_FILTER", 0x2600, "GL_NEAREST"},
    GlWord{"GL_TEXTURE_MAG_FILTER", 0x2601, "GL_LINEAR"},
    GlWord{"glGetError", 0x0500, "GL_INVALID_ENUM"},
    GlWord{"glGetError", 0x0501, "GL_INVALID_VALUE"},
    GlWord{"glGetError", 0x0502, "GL_INVALID_OPERATION"},
    GlWord{"glGetError", 0x0503, "GL_STACK_OVERFLOW"},
    GlWord{"glGetError", 0x0504, "GL_STACK_UNDERFLOW"},
    GlWord{"glGetError", 0x0505, "GL_OUT_OF_MEMORY"},
    GlWord{"glGetError", 0x0506, "GL_INVALID_FRAMEBUFFER_OPERATION"},
};

}

std::string_view gl_word(std::string_view column, double value)
{
    const auto* const found = std::ranges::find_if(
        words, [&](const GlWord& one) { return value == one.value && column.starts_with(one.column); });
    return found == words.end() ? std::string_view() : found->word;
}

}
