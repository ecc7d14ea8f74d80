#pragma once

#include <cstddef>
#include <cstdint>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>
#include <umbral/lighting/light_frame.hpp>
#include <vector>

namespace umbral::lighting {

// A lit scene through OpenGL's fixed function: glLight, glMaterial, glLightModel, glShadeModel.
//
// What all three functions find: no program in use, no texture, vertex array object 0, no buffer bound, no client array
// enabled, no face culled, the polygon mode GL_FILL. Anything may be all else that they need: matrices and matrix mode,
// each parameter of each light, the light model, the materials, GL_COLOR_MATERIAL and what it tracks, the shade model,
// GL_NORMALIZE, the front face, the current colour. Each stack of matrices has place for two more.

struct PlacedLight {
    Light light;  ///< in the coordinates of its frame
    LightFrame frame = LightFrame::world;
};

/// How a frame is lit.
struct FrameLighting {
    std::vector<PlacedLight> lights;  ///< any number; only the first eight count
    glm::vec3 global_ambient{0};      ///< A_G
    bool local_viewer = true;   ///< true, for perspective: v = -p / |p|; false, for parallel projections: (0, 0, 1)
    bool flat_shading = false;  ///< true: a triangle has the colour of its last vertex; false: interpolated
};

/// Once a frame. From now on a vertex at p in eye coordinates, with the normal n, has the colour
///
///     M_E + A_G M_A + Σ Sᵢ (M_A + M_D max(0, n·lᵢ) + M_S dᵢ max(0, n·hᵢ)^e)
///
/// in which dᵢ is 1 if n·lᵢ > 0, and else 0; lᵢ leads to the light, hᵢ is l + v made unit, and n is the vertex's normal
/// made unit, whatever its length and the modelview matrix. Distance weakens no light, and none is a spotlight. On back
/// faces n is turned round. Sᵢ is the ambient, the diffuse and the specular colour of OpenGL's light i; lights that do
/// not count are off. GL_LIGHTING is on, GL_COLOR_MATERIAL off. `view` takes the world to the eye; it turns and moves.
///
/// The matrices, the depth of their stacks, and the matrix mode stay as they were. Course: CauceFijo::fijarFuentesLuz,
/// fijarModoSombrPlano, section C 1.10; lab 4, R6.
void set_lighting(const FrameLighting& lighting, const glm::mat4& view);

/// Of what the next things are made, on their front and on their back; as alpha 1. OpenGL knows exponents up to 128: a
/// larger one is taken for 128. Called after set_lighting, any number of times. Course: CauceFijo::fijarParamsMIL;
/// lab 4, R5.
void set_material(const Material& material);

/// Triangles with a normal at each vertex: as many normals as positions, of any length but 0, outwards; indices come in
/// threes, each less than the number of positions.
struct LitMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
};

/// A mesh in the world. Several things may share one.
struct LitThing {
    std::size_t mesh = 0;  ///< its place among the scene's meshes
    glm::mat4 model{1};    ///< affine and invertible; it may stretch, and it may mirror
    Material material;
};

struct LitScene {
    glm::mat4 view{1};        ///< turns and moves
    glm::mat4 projection{1};  ///< of perspective, or parallel; it does not mirror
    FrameLighting lighting;
    std::vector<LitMesh> meshes;
    std::vector<LitThing> things;
};

/// Draws the things in their order, lit as above, with one draw call each (glDrawElements, or one pair of glBegin and
/// glEnd).
///
/// The front of a triangle is the side from which its corners are anticlockwise **in the mesh's coordinates**: a thing
/// that is mirrored is lit on its outside, too. Leaves all state as it was, but for the current normal: also what
/// set_lighting and set_material set. Makes no object of OpenGL. Tables may be empty. Course: section C 1.10, "estado".
void draw_lit(const LitScene& scene);

}
