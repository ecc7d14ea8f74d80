#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::texturing {

// Lab 4 of the course, line by line of its rubric, and then the program.
//
// The parts meet in OpenGL's own state (compatibility profile): lights in glLight, materials in glMaterial, matrices in
// the stacks of GL_MODELVIEW and GL_PROJECTION, textures bound to GL_TEXTURE_2D of unit 0, generation in glTexGen. Each
// part finds there what another one set, whoever that was. Who draws with shaders reads the same state in GLSL:
// gl_LightSource, gl_FrontMaterial, gl_ModelViewMatrix.

/// The lab's two tables of normals, unit or zero.
struct NormalTables {
    std::vector<glm::vec3> faces;     ///< one a triangle, in the mesh's order
    std::vector<glm::vec3> vertices;  ///< one a vertex
};

/// Rubric 1: "Cálculo de las tablas de normales de caras y vértices".
///
/// Of the triangle (p, q, r), the direction of (q - p) × (r - p); zero where that product is zero. Of a vertex, the
/// direction of the sum of the *unit* normals of the triangles that have it as a corner, each as often as it is one;
/// zero where the sum is shorter than 10⁻⁶. Takes time in proportion to vertices plus triangles. Course: lab 4, 4.2.1.
[[nodiscard]] NormalTables normals_of(const meshes::IndexedMesh& mesh);

/// A mesh with all its tables.
struct LitMesh {
    meshes::IndexedMesh mesh;
    NormalTables normals;
    std::vector<glm::vec2> coordinates;  ///< (s, t) of each vertex; empty for a mesh without
};

/// The lab's two modes with lighting.
enum class Shading { flat, smooth };

/// Rubric 2: "Incorporación de la tabla de coordenadas de textura a las mallas y su visualización".
///
/// Draws all triangles with the state that it finds (matrices, lights, material, texture). Flat: by the table of the
/// faces' normals, one colour a triangle. Smooth (Gouraud): by that of the vertices; light is computed at vertices and
/// interpolated. Coordinates go with the vertices if there are any. Colours are not sent. Tables may be empty.
///
/// Leaves the current colour and the modes of glEnable as they were, no array enabled, no buffer bound, no program in
/// use. Course: lab 4, 4.2.2.
void draw(const LitMesh& mesh, Shading shading);

/// What a profile sweeps.
struct Revolved {
    meshes::IndexedMesh mesh;
    std::vector<glm::vec2> coordinates;  ///< one a vertex
};

/// Rubric 3: "Código de asignación de coordenadas de textura al objeto de revolución".
///
/// A profile of M ≥ 2 points (x, y), x ≥ 0 its distance from the y axis, in N = `copies` ≥ 4 copies. Copy i is turned
/// by 2π i / (N - 1), counter-clockwise seen from +y: (x, y) goes to (x cos, y, -x sin). The last copy lies where the
/// first one does, and is another: its s is 1. Point j of copy i is vertex i M + j.
///
/// s = i / (N - 1). t = d_j / d_{M-1} with d the length of the profile up to the point; not all points coincide.
/// Triangles, for i < N - 1, j < M - 1, a = i M + j, b = a + M: (a, b, b + 1) and (a, b + 1, a + 1), in any order; you
/// may leave out those that have no area, or not. Course: lab 4, 4.2.3.
[[nodiscard]] Revolved revolve(std::span<const glm::vec2> profile, std::uint32_t copies);

/// What a picture file holds: red, green, blue, a byte each; rows from the top down, without padding.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A texture of the lab: its texels in memory, its name in OpenGL, and how its coordinates come about.
struct LabTexture {
    Picture picture;
    unsigned name = 0;       ///< 0 until it is activated for the first time
    bool generates = false;  ///< coordinates are generated; else they come with the vertices
    glm::vec4 s_plane{0};    ///< s = s_plane · (x, y, z, 1) in object coordinates, if it generates
    glm::vec4 t_plane{0};
};

/// Rubric 4: "Código de carga y visualización de texturas".
///
/// Enables GL_TEXTURE_2D and binds the texture; generation (GL_OBJECT_LINEAR, s and t) is enabled with its planes if
/// the texture generates, and disabled if not. The first time it makes the texture: a new name, and the texels go to
/// OpenGL, once; later calls upload nothing. t = 0 is the bottom of the picture, t = 1 its top. Outside [0, 1] the
/// texture repeats. Filters are yours; at a texel's own centre they must give that texel. Course: lab 4, 4.2.5.
void activate_texture(LabTexture& texture);

/// A material of the lab. The fourth component is 1: opaque.
struct Material {
    glm::vec4 ambient{0, 0, 0, 1};   ///< M_A
    glm::vec4 diffuse{0, 0, 0, 1};   ///< M_D
    glm::vec4 specular{0, 0, 0, 1};  ///< M_S
    float exponent = 0;              ///< e, 0 to 128
    LabTexture* texture = nullptr;   ///< null: none
};

/// The scene's materials.
struct Materials {
    Material label;  ///< the can's body
    Material metal;  ///< its two ends
    Material wood;
    Material white;
    Material black;
};

/// Rubric 5: "Definición correcta de materiales y su código de activación".
///
/// The lab leaves the numbers open; ours, so that pictures can be compared (three equal components unless three are
/// given):
///
///            M_A               M_D               M_S               e    texture
///     label  0.25              0.80              0.35              40   `label`
///     metal  0.22              0.34              0.85              24   none
///     wood   0.28              0.75              0.30              30   `wood`
///     white  0.26 0.25 0.24    0.74 0.72 0.68    0                 0    none
///     black  0.03              0.04              0.70              60   none
[[nodiscard]] Materials make_materials(LabTexture& label, LabTexture& wood);

/// Rubric 5, activation: enables GL_LIGHTING, sets the material of front faces (back faces may have it too, or not),
/// and activates the material's texture; without one, textures are disabled. Emission stays 0. Course: lab 4, 4.2.6.
void activate_material(const Material& material);

/// A light of the lab.
struct Light {
    glm::vec3 color{1};       ///< S
    bool directional = true;  ///< else positional
    float alpha = 0;          ///< radians, longitude; of a directional light
    float beta = 0;           ///< radians, latitude, up; in [-π/2, π/2]
    glm::vec3 position{0};    ///< of a positional light, in the world
};

/// Rubric 6: "Definición de fuentes de luz, del código de activación, y de la modificación interactiva de la dirección
/// de una de ellas". The unit vector **towards** the light: +z for α = β = 0; β > 0 lifts it to +y, then α turns it
/// about the y axis from +z to +x. Course: lab 4, 4.2.4 (where the sign of β is left open).
[[nodiscard]] glm::vec3 direction(float alpha, float beta);

/// Rubric 6, activation: the lights become GL_LIGHT0, GL_LIGHT1, … (8 at most), enabled; all others are disabled. S is
/// the light's ambient, diffuse and specular colour; without attenuation; no ambient light beside theirs; highlights
/// are added after the texture (GL_SEPARATE_SPECULAR_COLOR).
///
/// A directional light is fixed to the camera: its direction is one of eye coordinates, whatever the view. A positional
/// one stays in the world, which `view` leads to eye coordinates. The matrix stacks are left as they were.
void activate_lights(std::span<const Light> lights, const glm::mat4& view);

}
