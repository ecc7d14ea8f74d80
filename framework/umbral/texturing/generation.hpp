#pragma once

#include <glm/glm.hpp>
#include <string>
#include <umbral/core/not_implemented.hpp>

namespace umbral::texturing {

/// Where a vertex has its texture coordinates from: its own ones, or a linear function of its place in object or in eye
/// coordinates. In the course 0, 1 and 2 (tipo_gct).
enum class Generation { off, object, eye };

/// How texture coordinates are generated: s = dot(s_plane, p) and t = dot(t_plane, p), where p is (x, y, z, w) of the
/// vertex as the program hands it over (object), or multiplied by the modelview matrix (eye). No division by w.
struct Generator {
    Generation generation = Generation::off;
    glm::vec4 s_plane{1, 0, 0, 0};
    glm::vec4 t_plane{0, 1, 0, 0};
};

/// The coefficients (a, b, c, d) of the function that is 0 at `origin` and grows along `axis`: a x + b y + c z + d =
/// dot(axis, p - origin) for every point p. An axis of length n repeats the texture n times a unit; it may be zero.
/// Course: "generación de coordenadas de textura", as, bs, cs, ds.
[[nodiscard]] glm::vec4 plane_along(const glm::vec3& origin, const glm::vec3& axis);

/// Fixed pipeline: what is drawn from now on, with the texture unit that is active, gets its s and t so. With
/// Generation::off it has those of glTexCoord.
///
/// **Eye planes hold in eye coordinates, whatever the modelview matrix is at this call.** Sets GL_TEXTURE_GEN_S and _T,
/// their modes and planes; leaves all else as it is: the matrix mode, the matrices and the depths of their stacks, and
/// whether GL_TEXTURE_2D is enabled. One matrix more must fit on the modelview stack. Needs a current context. Course:
/// glTexGen, CauceFijo::fijarTipoGCT.
void set_generator(const Generator& generator);

/// Programmable pipeline: the text of a vertex shader (GLSL 3.30) that does the same.
///
/// Attributes: `in vec4 position` (object coordinates, any w), `in vec2 tex_coord`, `in vec3 color`. Uniforms: `mat4
/// modelview`, `mat4 projection`, `int generation` (0, 1, 2 as above), `vec4 s_plane`, `vec4 t_plane`. Writes
/// gl_Position = projection modelview position, `out vec2 st`, and `out vec3 shade`, which is the vertex' colour.
/// Course: CoordsTextura(), CauceProgramable::fijarTipoGCT.
[[nodiscard]] std::string generator_vertex_shader();

}
