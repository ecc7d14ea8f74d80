// alternative: OpenGL 4.5's direct state access, which names objects instead of binding them; row by row
#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/upload.hpp>

namespace umbral::texturing {
namespace {

struct NamedTexture : Texture {
    Grid<glm::u8vec3> picture;
    Sampler sampler;
    bool mipmaps;
    GLuint name = 0;

    NamedTexture(Grid<glm::u8vec3> its_picture, const Sampler& its_sampler, bool has_mipmaps)
        : picture(std::move(its_picture)), sampler(its_sampler), mipmaps(has_mipmaps)
    {
    }
    NamedTexture(const NamedTexture&) = delete;
    NamedTexture& operator=(const NamedTexture&) = delete;
    ~NamedTexture() override { glDeleteTextures(1, &name); }

    void activate(int unit) override
    {
        if (name == 0) make();
        glBindTextureUnit(static_cast<GLuint>(unit), name);
    }

    void make()
    {
        int levels = 1;
        while (mipmaps && std::max(picture.width, picture.height) >> levels > 0) ++levels;
        glCreateTextures(GL_TEXTURE_2D, 1, &name);
        glTextureStorage2D(name, levels, GL_RGB8, picture.width, picture.height);
        // One row alone needs no padding.
        for (int row = 0; row < picture.height; ++row)
            glTextureSubImage2D(name, 0, 0, picture.height - 1 - row, picture.width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                                &picture.at(0, row));
        if (mipmaps) glGenerateTextureMipmap(name);
        const bool nearest = sampler.filter == Filter::nearest;
        glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
        glTextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                            mipmaps   ? GL_LINEAR_MIPMAP_LINEAR
                            : nearest ? GL_NEAREST
                                      : GL_LINEAR);
        const auto wrap = [](Wrap way) { return way == Wrap::clamp_to_edge ? GL_CLAMP_TO_EDGE : GL_REPEAT; };
        glTextureParameteri(name, GL_TEXTURE_WRAP_S, wrap(sampler.wrap_u));
        glTextureParameteri(name, GL_TEXTURE_WRAP_T, wrap(sampler.wrap_v));
    }
};

}

std::unique_ptr<Texture> make_texture(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
{
    return std::make_unique<NamedTexture>(picture, sampler, mipmaps);
}

}
