#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/picture.hpp>
#include <limits>

#include "support.hpp"

/// What a camera sees, without any light: the place and the normal at each sample, for units that give them light.
/// Pictures are drawn at twice their size and halved.
namespace umbral::lighting {

/// What is seen at one sample.
struct Visible {
    SurfacePoint at;  ///< in the world, with a unit normal
    int thing = 0;    ///< which one; 0: nothing
    float depth = std::numeric_limits<float>::infinity();
};

using View = Grid<Visible>;

inline View empty_view(int width, int height) { return {2 * width, 2 * height}; }

/// Draws the front sides of a shape; triangles that reach behind the near plane are left out. `camera` is projection *
/// view.
inline void draw(View& view, const glm::mat4& camera, const Shape& shape, const glm::mat4& model, int thing)
{
    struct Vertex {
        SurfacePoint at;
        glm::vec3 screen{0};  // x, y in pixels, 1 / w
        float depth = 0;
    };
    const glm::mat3 turned = glm::transpose(glm::inverse(glm::mat3(model)));
    const glm::vec2 size(view.width, view.height);
    std::vector<Vertex> vertices(shape.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec4 world = model * glm::vec4(shape.positions[i], 1);
        const glm::vec4 clip = camera * world;
        vertices[i].at = {glm::vec3(world), normalize(turned * shape.normals[i])};
        const glm::vec2 ndc = glm::vec2(clip) / clip.w;
        vertices[i].screen = {(0.5F + 0.5F * ndc.x) * size.x, (0.5F - 0.5F * ndc.y) * size.y, 1 / clip.w};
        vertices[i].depth = clip.z / clip.w;
    }
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const Vertex* const v[] = {&vertices[shape.indices[i]], &vertices[shape.indices[i + 1]],
                                   &vertices[shape.indices[i + 2]]};
        if (std::min({v[0]->screen.z, v[1]->screen.z, v[2]->screen.z}) <= 0) continue;
        const glm::vec2 a(v[0]->screen);
        const glm::vec2 b(v[1]->screen);
        const glm::vec2 c(v[2]->screen);
        const auto twice = [](glm::vec2 p, glm::vec2 q, glm::vec2 r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        const float area = -twice(a, b, c);  // y goes down: what turns anticlockwise on the screen counts
        if (!(area > 0)) continue;
        const glm::vec2 low = max(min(min(a, b), c), glm::vec2(0));
        const glm::vec2 high = min(max(max(a, b), c), size - 1.0F);
        for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
            for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
                const glm::vec2 p = glm::vec2(x, y) + 0.5F;
                glm::vec3 weights = -glm::vec3(twice(b, c, p), twice(c, a, p), twice(a, b, p)) / area;
                if (std::min({weights.x, weights.y, weights.z}) < 0) continue;
                const float depth = weights.x * v[0]->depth + weights.y * v[1]->depth + weights.z * v[2]->depth;
                Visible& seen = view.at(x, y);
                if (depth >= seen.depth) continue;
                weights *= glm::vec3(v[0]->screen.z, v[1]->screen.z, v[2]->screen.z);
                weights /= weights.x + weights.y + weights.z;
                seen = {{}, thing, depth};
                glm::vec3 normal(0);
                for (int k = 0; k < 3; ++k) {
                    seen.at.position += weights[k] * v[k]->at.position;
                    normal += weights[k] * v[k]->at.normal;
                }
                seen.at.normal = normalize(normal);
            }
    }
}

/// The picture of a view where each thing gets the linear light shade(visible), and nothing the background's.
template <class Shade>
Image lit_picture(const View& view, const glm::vec3& background, Shade shade)
{
    Grid<glm::vec3> light(view.width, view.height);
    std::transform(view.cells.begin(), view.cells.end(), light.cells.begin(),
                   [&](const Visible& seen) { return seen.thing == 0 ? background : shade(seen); });
    return halved(encoded(light));
}

}
