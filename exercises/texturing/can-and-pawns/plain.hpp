#pragma once

#include <array>
#include <kit/double_frame.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "artwork.hpp"
#include "earlier.hpp"

/// What the parts of the lab are tried on: small meshes, textures and lights of the driver's own.
namespace umbral::texturing {

inline meshes::IndexedMesh cube()
{
    meshes::IndexedMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

inline meshes::IndexedMesh tetrahedron()
{
    return {{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// The mesh turned exactly, as it is unless inputs are to vary.
inline meshes::IndexedMesh turned(Variation& vary, meshes::IndexedMesh mesh)
{
    const ExactMap map = vary.exact_map();
    for (glm::vec3& position : mesh.positions) position = map.place(position);
    return mesh;
}

/// An open surface over a grid of size² squares in [-1, 1]², its inner vertices moved, its heights random.
inline meshes::IndexedMesh patch(Random& random, int size, float reach = 1)
{
    meshes::IndexedMesh mesh;
    const float step = 2 * reach / static_cast<float>(size);
    for (int y = 0; y <= size; ++y)
        for (int x = 0; x <= size; ++x) {
            const float moved = x == 0 || y == 0 || x == size || y == size ? 0 : 0.25F * step;
            const float right = random.uniform(-moved, moved);
            const float up = random.uniform(-moved, moved);
            mesh.positions.emplace_back(step * static_cast<float>(x) - reach + right,
                                        step * static_cast<float>(y) - reach + up, random.uniform(-0.3F, 0.3F));
        }
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto a = static_cast<std::uint32_t>(y * (size + 1) + x);
            const auto b = a + static_cast<std::uint32_t>(size) + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
        }
    return mesh;
}

/// Degenerate: a triangle that names a vertex twice, one on a line, two back to back, and a vertex of none.
inline meshes::IndexedMesh with_degenerate_ones()
{
    meshes::IndexedMesh mesh = tetrahedron();
    mesh.positions.insert(mesh.positions.end(), {{2, 2, 2}, {3, 3, 3}, {9, 9, 9}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
    mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 3}, {0, 4, 5}, {7, 8, 9}, {7, 9, 8}});
    return mesh;
}

/// A unit vector that looks towards +z.
inline glm::vec3 towards_viewer(Random& random)
{
    const glm::vec2 xy(random.uniform(-0.65F, 0.65F), random.uniform(-0.65F, 0.65F));
    return {xy, std::sqrt(1 - dot(xy, xy))};
}

/// A flat patch with normals and coordinates that have nothing to do with its shape, so that a picture tells which
/// table was used.
inline LitMesh motley(Random& random, int size, bool with_coordinates)
{
    LitMesh mesh{patch(random, size, 0.92F), {}, {}};
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i) mesh.normals.faces.push_back(towards_viewer(random));
    for (const glm::vec3& place : mesh.mesh.positions) {
        mesh.normals.vertices.push_back(towards_viewer(random));
        const glm::vec2 st(random.uniform(-0.15F, 0.15F) + 0.5F + 0.5F * place.y,
                           random.uniform(-0.15F, 0.15F) + 0.5F - 0.5F * place.x);
        if (with_coordinates) mesh.coordinates.push_back(st);
    }
    return mesh;
}

/// No two texels are alike.
inline Picture random_picture(Random& random, int width, int height)
{
    Picture picture{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i) picture.rgb.push_back(static_cast<std::uint8_t>(random.below(256)));
    return picture;
}

/// Red, green and blue light from the right, from above and from the viewer: a white thing shows its normals.
inline void light_by_normals()
{
    constexpr std::array<glm::vec3, 3> towards = {{{1, 0, 0.35F}, {-0.3F, 1, 0.35F}, {0, -0.5F, 1}}};
    glUseProgram(0);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    const glm::vec4 none(0, 0, 0, 1);
    const glm::vec4 white(1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, value_ptr(none));
    for (GLenum i = 0; i < 3; ++i) {
        glm::vec4 color = none;
        color[static_cast<int>(i)] = 1;
        const glm::vec4 direction(towards[i], 0);
        glLightfv(GL_LIGHT0 + i, GL_POSITION, value_ptr(direction));
        glLightfv(GL_LIGHT0 + i, GL_DIFFUSE, value_ptr(color));
        glLightfv(GL_LIGHT0 + i, GL_AMBIENT, value_ptr(none));
        glLightfv(GL_LIGHT0 + i, GL_SPECULAR, value_ptr(none));
        glEnable(GL_LIGHT0 + i);
    }
    for (const GLenum part : {GL_AMBIENT, GL_SPECULAR}) glMaterialfv(GL_FRONT_AND_BACK, part, value_ptr(none));
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, value_ptr(white));
    glEnable(GL_LIGHTING);
}

/// A texture of the driver's own while it lives, enabled and bound: a soft rainbow with dark lines.
class RainbowTexture {
public:
    RainbowTexture()
    {
        constexpr int size = 64;
        const Picture picture = painted_picture(size, size, [](double x, double y) {
            const bool line = std::fmod(8 * x, 1.0) < 0.14 || std::fmod(8 * y, 1.0) < 0.14;
            return glm::dvec3(rainbow(static_cast<float>(0.7 * x), 0.5F, 1)) * (line ? 0.25 : 0.5 + 0.5 * y);
        });
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
        glEnable(GL_TEXTURE_2D);
    }
    RainbowTexture(const RainbowTexture&) = delete;
    RainbowTexture& operator=(const RainbowTexture&) = delete;
    ~RainbowTexture()
    {
        glDisable(GL_TEXTURE_2D);
        glDeleteTextures(1, &name_);
    }

private:
    GLuint name_ = 0;
};

/// A rectangle that fills the viewport, with coordinates from 0 to 1 and places from -1 to 1.
inline void draw_rectangle()
{
    glUseProgram(0);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glDisable(GL_LIGHTING);
    glColor3f(1, 1, 1);
    glBegin(GL_QUADS);
    for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        glTexCoord2fv(value_ptr(corner));
        glVertex2f(2 * corner.x - 1, 2 * corner.y - 1);
    }
    glEnd();
}

}
