// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Core Profile). 2017,
// sections 8.1 (texture objects and units), 8.4.4 (how rows of pictures are read) and 8.14 (filters and wrapping).

#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/upload.hpp>
#include <vector>

namespace umbral::texturing {
namespace {

GLint state_of(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// Makes a texture unit the active one while it lives.
class ActiveUnit {
public:
    explicit ActiveUnit(int unit) : before_(static_cast<GLenum>(state_of(GL_ACTIVE_TEXTURE)))
    {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    }
    ActiveUnit(const ActiveUnit&) = delete;
    ActiveUnit& operator=(const ActiveUnit&) = delete;
    ~ActiveUnit() { glActiveTexture(before_); }

private:
    GLenum before_;
};

/// The texels as OpenGL reads them: the bottom row first.
std::vector<glm::u8vec3> bottom_row_first(const Grid<glm::u8vec3>& picture)
{
    std::vector<glm::u8vec3> texels;
    texels.reserve(picture.cells.size());
    for (int row = picture.height - 1; row >= 0; --row)
        for (int column = 0; column < picture.width; ++column) texels.push_back(picture.at(column, row));
    return texels;
}

GLint wrap_of(Wrap wrap) { return wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; }

class TextureObject : public Texture {
public:
    TextureObject(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
        : picture_(picture), sampler_(sampler), mipmaps_(mipmaps)
    {
    }
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;

    ~TextureObject() override
    {
        if (name_ != 0) glDeleteTextures(1, &name_);
    }

    void activate(int unit) override
    {
        const ActiveUnit active(unit);
        const bool is_first = name_ == 0;
        if (is_first) glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        if (is_first) upload();
    }

private:
    /// Into the texture that is bound.
    void upload()
    {
        // Rows of three bytes a texel follow each other without padding; OpenGL expects multiples of four bytes.
        const GLint alignment = state_of(GL_UNPACK_ALIGNMENT);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture_.width, picture_.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     bottom_row_first(picture_).data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);

        // The initial filter for minification reads mipmaps: without them the texture would be incomplete, and black.
        const GLint filter = sampler_.filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mipmaps_ ? GL_LINEAR_MIPMAP_LINEAR : filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(sampler_.wrap_u));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(sampler_.wrap_v));
        if (mipmaps_) glGenerateMipmap(GL_TEXTURE_2D);
        picture_ = {};
    }

    Grid<glm::u8vec3> picture_;  // empty when OpenGL has it
    Sampler sampler_;
    bool mipmaps_;
    GLuint name_ = 0;
};

}

std::unique_ptr<Texture> make_texture(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
{
    return std::make_unique<TextureObject>(picture, sampler, mipmaps);
}

}
