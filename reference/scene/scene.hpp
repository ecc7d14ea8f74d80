#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/shape.hpp"

/// What a picture is of: plain data, without answers, for every renderer alike.
///
/// World coordinates are right-handed. All colours are linear (light, not sRGB); 1 is white. Angles are in degrees
/// where a name says so, and times in seconds.
///
/// What is marked "rays only" is for renderers that follow rays; the others draw as if it were not there.
namespace umbral::scene {

/// Where the picture is taken from.
struct Camera {
    glm::vec3 eye{0, 0, 5};
    glm::vec3 target{0, 0, 0};
    glm::vec3 up{0, 1, 0};
    float fovy_degrees = 45;  ///< the whole vertical angle of view, in (0, 180)
    float near = 0.1F;        ///< distances along the view, 0 < near < far
    float far = 100;
    float lens_radius = 0;      ///< of a thin lens; 0: a pinhole, everything is sharp. Rays only
    float focus_distance = 0;   ///< of the plane that is sharp, along the view; 0: the target's. Rays only
    float shutter_seconds = 0;  ///< how long it stays open: what moves meanwhile is blurred; 0: a moment. Rays only
};

/// A light that is far away in one direction, or near at one place. Its strength does not fall off with distance.
struct Light {
    std::string name;
    bool positional = false;
    glm::vec3 where{0, 1, 0};  ///< its place, or the direction towards it (of any length but 0)
    glm::vec3 color{1, 1, 1};
    float radius = 0;              ///< of a ball of light round its place; 0: a point. Rays only
    float half_angle_degrees = 0;  ///< of a disc of light far away, as it is seen; 0: a point. Rays only
};

enum class TextureKind {
    checker,
    stripes,
    uv_grid,
    wood,    ///< rings of a trunk that is cut along, their grain along v; `cells` boards side by side
    marble,  ///< veins of the second colour in the first; `cells`: how fine
    bricks,  ///< of the first colour, each a little different, in mortar of the second; `cells` layers
    pores    ///< round dimples, the second colour at their bottom, in the first; `cells` a side, each a little aside
};

/// A texture that is computed when the scene is prepared. All join themselves without a seam.
struct Texture {
    std::string name;
    TextureKind kind = TextureKind::checker;
    int size = 512;        ///< texels a side
    int cells = 8;         ///< cells (or pairs of stripes) a side
    glm::vec3 first{1};    ///< colour of the lower left cell; not for uv_grid
    glm::vec3 second{0};   ///< colour of its neighbours; not for uv_grid
    bool bilinear = true;  ///< or the nearest texel
    bool repeat = true;    ///< or clamped to the edge
};

/// The terms of Blinn's model. A texture multiplies `ambient` and `diffuse`.
struct Material {
    std::string name;
    glm::vec3 emission{0};
    glm::vec3 ambient{0};
    glm::vec3 diffuse{1};
    glm::vec3 specular{0};
    float exponent = 1;                                 ///< of the highlight, ≥ 0
    std::optional<std::size_t> texture = std::nullopt;  ///< place in Scene::textures
    glm::vec2 texture_scale{1};                         ///< what (u, v) are multiplied by, for heights too
    glm::vec3 mirror{0};                                ///< share of light that is reflected as by a mirror. Rays only
    glm::vec3 transmit{0};                              ///< share of light that is let through. Rays only
    float index = 1;                                    ///< of refraction, inside; in [1, 4]. Rays only
    std::optional<std::size_t> bump = std::nullopt;     ///< place in Scene::textures of heights, their red. Rays only
    float bump_height = 0;  ///< how far red 1 lies above red 0, in the world; negative: below. Rays only
};

struct Translate {
    glm::vec3 by{0};
};
struct Rotate {
    glm::vec3 axis{0, 1, 0};  ///< of any length but 0; counter-clockwise as it points at you
    float degrees = 0;
};
struct Scale {
    glm::vec3 by{1};  ///< no factor is 0
};
/// Turns all the time; by nothing at time 0.
struct Spin {
    glm::vec3 axis{0, 1, 0};  ///< as Rotate's
    float degrees_per_second = 0;
};
/// Turns to and fro: by degrees · sin(2π (t / period + phase)).
struct Swing {
    glm::vec3 axis{0, 1, 0};  ///< as Rotate's
    float degrees = 0;        ///< the farthest, to either side
    float period = 1;         ///< in seconds, > 0
    float phase = 0;          ///< in periods
};
/// Goes on for ever, from the place that it has at time 0.
struct Move {
    glm::vec3 velocity{0};  ///< a second
};
/// Goes to and fro: by `by` · sin(2π (t / period + phase)).
struct Bob {
    glm::vec3 by{0};   ///< the farthest, to either side
    float period = 1;  ///< in seconds, > 0
    float phase = 0;   ///< in periods
};
/// The last four depend on time: at_time (motion.hpp) replaces them by what they are at one moment.
using Transform = std::variant<Translate, Rotate, Scale, Spin, Swing, Move, Bob>;

enum class Sides {
    front,  ///< triangles seen from behind are not drawn
    both    ///< they are, with their normal turned towards the viewer
};

/// One thing in the picture.
struct Instance {
    std::string name;                   ///< of one in a group: with the names of the groups before it, "arm/hand"
    std::size_t geometry = 0;           ///< place in Scene::geometries
    std::size_t material = 0;           ///< place in Scene::materials
    std::vector<Transform> transforms;  ///< the first one acts first
    bool smooth = true;                 ///< normals interpolated between vertices, or one for each triangle
    Sides sides = Sides::front;
};

struct Scene {
    std::string title;
    Camera camera;
    glm::vec3 background_top{0};     ///< colour where there is nothing: from the top row's …
    glm::vec3 background_bottom{0};  ///< … linearly to the bottom row's
    glm::vec3 ambient{0};            ///< light from everywhere
    int bounces = 0;                 ///< of light between surfaces that are no mirrors; 0: none. Rays only
    int depth = 8;                   ///< how many mirrors and panes of glass light may meet. Rays only
    float seconds = 0;               ///< how long its film is: after that time it starts anew; 0: it is still
    std::vector<Light> lights;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Geometry> geometries;
    std::vector<Instance> instances;
};

}
