#pragma once

#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {

/// A picture in the memory of the graphics card: one OpenGL texture object, made when it is first needed.
class Texture {
public:
    /// Deletes the texture object, if there is one. Needs a current OpenGL context only then.
    virtual ~Texture() = default;

    /// From now on texture unit `unit`, 0 to 15, has this texture as its GL_TEXTURE_2D.
    ///
    /// The first call makes the texture object and uploads the picture; all later ones bind it, and upload nothing.
    /// Needs a current OpenGL context. Changes nothing but which GL_TEXTURE_2D is bound to that unit: the active unit
    /// (glActiveTexture), GL_UNPACK_ALIGNMENT, the other units, all switches (glEnable) and other bindings are
    /// afterwards as they were. GL_UNPACK_ALIGNMENT may be 1, 2, 4 or 8 before; all else that governs how OpenGL reads
    /// pictures is as it is in a new context.
    virtual void activate(int unit) = 0;
};

/// A texture of `picture`, which has at least one pixel, any width and any height; the grid may change or go away
/// afterwards. Textures share nothing, so that several may live at once.
///
/// **Nothing of OpenGL is called here**: the first activate() does all of it (creación perezosa).
///
/// The picture's row 0 is its top row, as in files; t grows upwards, so that (0, 0) is the lower left corner. Texels
/// are red, green, blue, a byte each, which shaders read as byte / 255, with alpha 1: no other size, no conversion of
/// colours. `sampler` says what shaders read between the texels' centres, where the picture is magnified, and what
/// beyond its edges; wrap_u is along s, wrap_v along t. Where it is minified, the same filter takes texels of the
/// picture; or, with `mipmaps`, shaders read from the pyramid that glGenerateMipmap makes, trilinearly
/// (GL_LINEAR_MIPMAP_LINEAR), whatever the filter is. Course: lab 4, "código de carga y visualización de texturas";
/// glGenTextures, glActiveTexture, glBindTexture, glTexImage2D, class Textura.
[[nodiscard]] std::unique_ptr<Texture> make_texture(const Grid<glm::u8vec3>& picture, const Sampler& sampler,
                                                    bool mipmaps);

}
