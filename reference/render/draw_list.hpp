#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <umbral/core/grid.hpp>
#include <umbral/texturing/lookup.hpp>
#include <vector>

#include "render/surface.hpp"
#include "scene/scene.hpp"

namespace umbral::render {

struct Texture {
    Grid<glm::vec4> texels;
    texturing::Sampler sampler;
};

/// A light in eye space.
struct Light {
    glm::vec4 where;  ///< w = 1: its place; w = 0: the unit vector towards it
    glm::vec3 color;
    float size = 0;  ///< radius of the ball, or of the disc at distance 1 for one far away; for rays
};

/// Which part of an instance can be seen, told from the corners of its box.
enum class Visibility {
    outside,  ///< none: it lies wholly beyond one plane of the view volume, and is not drawn
    inside,   ///< nothing can need clipping
    crosses   ///< it may reach beyond the near plane, the far plane or the rasteriser's guard band
};

/// An instance, ready to be drawn.
struct Draw {
    std::uint32_t id = 0;  ///< place in the scene's instances, from 1
    std::string name;
    Visibility visibility = Visibility::inside;
    std::size_t mesh = 0;  ///< place in DrawList::meshes
    glm::mat4 model_view{1};
    glm::mat3 normal_matrix{1};  ///< takes normals to eye space; the result is not unit
    bool mirrored = false;       ///< the transform turns counter-clockwise into clockwise
    bool smooth = true;
    bool both_sides = false;
    bool specular = false;  ///< its material has a specular colour
    scene::Material material;
    std::optional<std::size_t> texture;  ///< place in DrawList::textures, where it can be seen
    std::optional<std::size_t> bump;     ///< place in DrawList::textures of heights; for rays
};

/// A scene prepared for one aspect ratio: what the renderers take. All of them read the same matrices and vertices, so
/// that they can only differ in how they draw.
struct DrawList {
    glm::mat4 projection{1};
    glm::vec3 ambient{0};
    std::vector<Light> lights;
    std::vector<Texture> textures;
    std::vector<VertexMesh> meshes;
    std::vector<Draw> draws;
    // What only rays need.
    scene::Camera camera;         ///< as the scene has it; its focus_distance is given
    glm::vec3 up{0, 1, 0};        ///< the world's y axis
    glm::vec3 background_top{0};  ///< what rays see that lead up to the sky …
    glm::vec3 background_bottom{0};
    int bounces = 0;
    int depth = 0;
};

/// The perspective that `camera` asks for, in OpenGL's clip space; computed in double, rounded once.
/// Course: MAT_Perspective.
[[nodiscard]] glm::mat4 projection_matrix(const scene::Camera& camera, double aspect);

/// The product of the transforms, the first of which acts first.
[[nodiscard]] glm::mat4 model_matrix(const std::vector<scene::Transform>& transforms);

/// Prepares a scene for pictures of width x height pixels. Meshes that no instance uses are
/// not made, nor textures that nothing needs that can be seen; but `for_rays` the unseen counts too, as mirrors show
/// it.
[[nodiscard]] DrawList make_draw_list(const scene::Scene& scene, int width, int height, bool for_rays = false);

}
