#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/grid.hpp>
#include <vector>

/// A picture as plain data, which every painter draws alike.
namespace umbral::bench::scenes {

struct Vertex {
    glm::vec3 position{0};
    glm::vec3 normal{0, 0, 1};
    glm::vec2 uv{0};
    glm::vec4 color{1};
};

/// Three corners a triangle, counter-clockwise seen from the front.
using Triangles = std::vector<Vertex>;

struct Camera {
    glm::vec3 eye{0, 0, 5};
    glm::vec3 target{0};
    glm::vec3 up{0, 1, 0};
    float fovy_degrees = 40;
    float near = 0.5F;
    float far = 50;
    float ortho_height = 0;     ///< above 0: orthographic, this high
    bool takes_square = false;  ///< the projection ignores the picture's shape
};

struct Light {
    glm::vec4 place{0, 1, 0, 0};  ///< in the world; w = 0 is a direction
    glm::vec3 color{1};
    glm::vec3 falloff{1, 0, 0};  ///< of 1, distance, distance squared
    glm::vec3 aim{0, -1, 0};     ///< of a spot, unit
    float cone = -2;             ///< the cosine of a spot's half angle; -2 for lights that are none
    float focus = 0;             ///< exponent of a spot's cosine
};

enum class Style { plain, lit, toon, mirror, bumpy };

struct Material {
    glm::vec4 color{1};
    glm::vec3 specular{0};
    float shininess = 1;
    Style style = Style::lit;
    float bands = 4;  ///< of toon shading
    glm::vec2 uv_scale{1};
    bool alpha_test = false;
};

/// Row 0 is v = 0.
struct Texture {
    Image texels;
    bool linear = true;
    bool repeat = true;
    bool mipmaps = false;
};

enum class Blend { none, over, add };
enum class Cull { none, back, front };

/// What one call draws.
struct Batch {
    Triangles corners;
    bool lines = false;  ///< two corners a line instead; OpenGL only
    std::size_t edge_corners =
        0;  ///< corners a line: 2 for lines, 6 for lines made of two triangles; 0 where there are none
    glm::mat4 model{1};
    Material material;
    std::optional<std::size_t> texture;  ///< place in Model::textures
    Blend blend = Blend::none;
    Cull cull = Cull::none;
    bool depth_test = true;
    bool depth_write = true;
    float depth_offset = 0;  ///< nearer by this much, of a depth range from -1 to 1
};

struct Fog {
    glm::vec3 color{0};
    float density = 0;  ///< 0 for none
};

struct Model {
    int width = 256;
    int height = 256;
    Camera camera;
    glm::vec4 background{0.08F, 0.09F, 0.12F, 1};
    glm::vec3 ambient{0.15F};
    std::vector<Light> lights;
    Fog fog;
    bool encoded = true;  ///< light is linear, the picture encoded by 1/2.2
    bool farthest_wins = false;
    glm::vec2 moved{0};  ///< in pixels, right and down
    float line_width = 1;
    std::vector<Texture> textures;
    std::vector<Batch> batches;
};

}
