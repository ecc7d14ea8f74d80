// alternative: four bytes a texel, which are aligned for every width; flipped and widened when the object is made
#include <optional>
#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/upload.hpp>

namespace umbral::texturing {
namespace {

class WideTexture : public Texture {
    std::vector<GLubyte> bytes;
    GLsizei columns, rows;
    Sampler how;
    bool pyramid;
    std::optional<GLuint> id;

    static GLenum wrapping(Wrap wrap)
    {
        switch (wrap) {
            case Wrap::repeat: return GL_REPEAT;
            case Wrap::clamp_to_edge: return GL_CLAMP_TO_EDGE;
        }
        return GL_REPEAT;
    }

    void set(GLenum parameter, GLenum value) { glTexParameteri(GL_TEXTURE_2D, parameter, static_cast<GLint>(value)); }

    void create()
    {
        GLuint made = 0;
        glGenTextures(1, &made);
        id = made;
        glBindTexture(GL_TEXTURE_2D, *id);
        set(GL_TEXTURE_MAG_FILTER, how.filter == Filter::bilinear ? GL_LINEAR : GL_NEAREST);
        set(GL_TEXTURE_MIN_FILTER, how.filter == Filter::bilinear ? GL_LINEAR : GL_NEAREST);
        set(GL_TEXTURE_WRAP_S, wrapping(how.wrap_u));
        set(GL_TEXTURE_WRAP_T, wrapping(how.wrap_v));
        GLint before = 0;
        glGetIntegerv(GL_UNPACK_ALIGNMENT, &before);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, columns, rows, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, before);
        if (!pyramid) return;
        set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glGenerateMipmap(GL_TEXTURE_2D);
    }

public:
    WideTexture(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
        : columns(picture.width), rows(picture.height), how(sampler), pyramid(mipmaps)
    {
        for (int y = rows; y-- > 0;)
            for (int x = 0; x < columns; ++x) {
                const glm::u8vec3 texel = picture.at(x, y);
                bytes.insert(bytes.end(), {texel.r, texel.g, texel.b, GLubyte{255}});
            }
    }
    WideTexture(const WideTexture&) = delete;
    WideTexture& operator=(const WideTexture&) = delete;
    ~WideTexture() override
    {
        if (id) glDeleteTextures(1, &*id);
    }

    void activate(int unit) override
    {
        GLint active = 0;
        glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
        glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
        if (id)
            glBindTexture(GL_TEXTURE_2D, *id);
        else
            create();
        glActiveTexture(static_cast<GLenum>(active));
    }
};

}

std::unique_ptr<Texture> make_texture(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
{
    return std::make_unique<WideTexture>(picture, sampler, mipmaps);
}

}
