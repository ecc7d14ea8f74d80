#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::interaction {

/// An identifier as a colour, red the least significant byte: id = red + 256 green + 65536 blue. So 123456 is (64, 226,
/// 1). Throws std::invalid_argument if the id has no room in three bytes (2^24 or more). Course: FijarColorIdent.
[[nodiscard]] glm::u8vec3 color_of_id(std::uint32_t id);

/// The inverse. Course: LeerIdentEnPixel.
[[nodiscard]] std::uint32_t id_of_color(const glm::u8vec3& color);

/// Triangles: three indices each, less than the number of positions. Both of their sides are seen. May be empty.
struct PickMesh {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
};

/// A mesh in the world. Several things may share a mesh, and several may have the same id.
struct PickThing {
    std::size_t mesh = 0;  ///< its place among the scene's meshes
    glm::mat4 model{1};    ///< affine
    std::uint32_t id = 0;  ///< less than 2^24. 0: it cannot be picked, and hides nothing, as a drawing of the axes
};

struct PickScene {
    glm::mat4 view{1};
    glm::mat4 projection{1};  ///< to OpenGL's clip coordinates
    std::vector<PickMesh> meshes;
    std::vector<PickThing> things;
};

/// Draws scenes in colours that stand for ids, where nobody sees them: into a framebuffer object of its own.
///
/// What its functions find: a current OpenGL context; vertex array object 0, no buffer bound, no client array enabled;
/// texture unit 0 the active one; places for one more in each stack. Anything may be: the framebuffers bound for
/// drawing and for reading, and the renderbuffer; the viewport; the program in use; GL_LIGHTING, GL_TEXTURE_2D, GL_FOG,
/// GL_BLEND, GL_ALPHA_TEST, GL_DITHER, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST
/// and what governs them; the masks, ranges and clear values of colours and depths; the shade model, the polygon mode
/// and the current colour; the matrices and the matrix mode. All else is as in a new context.
class IdPicker {
public:
    /// Deletes every object of OpenGL that it made. Needs a current context only if `ids_around` was called.
    virtual ~IdPicker() = default;

    /// The ids of the pixels in a square of 2 radius + 1 pixels a side round `pixel`: each is that of the nearest thing
    /// at the pixel's centre, and 0 where there is none, or where the square leaves the picture. Of two things whose
    /// depths there differ by less than 2^-17 of OpenGL's range it may be either.
    ///
    /// `picture` is the size of the picture of which the scene fills the whole, both sides > 0; it may differ from call
    /// to call. `pixel` is a column from the left and a row from the **top**, and may lie outside of the picture;
    /// radius >= 0. The grid's row 0 is the top one, too.
    /// Leaves all state of OpenGL as it was, but for the current normal and texture coordinates, and every picture but
    /// its own. Objects of OpenGL are made at the first call, and again only if the picture's size is another one.
    /// Course: class Framebuffer, modo de identificadores.
    [[nodiscard]] virtual Grid<std::uint32_t> ids_around(const PickScene& scene, const glm::ivec2& picture,
                                                         const glm::ivec2& pixel, int radius) = 0;
};

/// A new one; it shares nothing with others. Calls nothing of OpenGL.
[[nodiscard]] std::unique_ptr<IdPicker> make_id_picker();

/// Of the ids that are not 0, the one whose pixel's centre is nearest to that of the middle pixel; of equally near
/// ones, the first one row by row, from the upper left. 0 if all are 0. The grid is square, its side odd, as from
/// `ids_around`: so that thin things can be picked from beside them.
[[nodiscard]] std::uint32_t nearest_id(const Grid<std::uint32_t>& ids);

}
