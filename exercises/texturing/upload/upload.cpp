#include <umbral/gl/opengl.hpp>
#include <umbral/texturing/upload.hpp>

namespace umbral::texturing {

// A class of your own that derives from Texture goes here. It keeps a copy of the picture, how it is sampled, and the
// name of its texture object, which is 0 as long as there is none.

std::unique_ptr<Texture> make_texture(const Grid<glm::u8vec3>& picture, const Sampler& sampler, bool mipmaps)
{
    // TODO: make an object of your class, and call nothing of OpenGL yet. Its activate() makes the unit active and
    // binds the texture; the first time it also makes it: name, rows, filters, wrapping, mipmaps.
    return not_implemented<std::unique_ptr<Texture>>(picture, sampler, mipmaps);
}

}
