#pragma once

#include <umbral/gl/opengl.hpp>
#include <umbral/gl/trace.hpp>

/// What textures there are, and what brought them there.
namespace umbral::texturing {

/// Calls of a trace that give texels to a texture, or room for them.
inline std::uint64_t texture_uploads(const gl::Trace& trace)
{
    std::uint64_t count = 0;
    for (const auto& [name, times] : trace.counts)
        for (const char* const family : {"glTexImage", "glTexSubImage", "glTextureSubImage", "glTexStorage",
                                         "glTextureStorage", "glCompressedTex", "glCopyTex"})
            if (name.starts_with(family)) count += times;
    return count;
}

/// The texels at level 0 of all textures, of the first names that there are.
inline float living_texels()
{
    GLint sum = 0;
    for (GLuint name = 1; name < 256; ++name) {
        if (glIsTexture(name) == GL_FALSE) continue;
        GLint width = 0;
        GLint height = 0;
        glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_WIDTH, &width);
        glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_HEIGHT, &height);
        sum += width * height;
    }
    return static_cast<float>(sum);
}

}
