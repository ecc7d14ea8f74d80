#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/shapes.hpp>
#include <umbral/core/random.hpp>
#include <umbral/interaction/pick_ids.hpp>
#include <vector>

/// Scenes to pick from, and how far pixels lie from where the answer changes.
namespace umbral::interaction {

inline PickMesh mesh_of(const shapes::Shape& shape) { return {shape.positions, shape.indices}; }

inline int random_up_to(int count, Random& random)
{
    return static_cast<int>(random.below(static_cast<std::uint32_t>(count)));
}

inline std::uint32_t random_id(Random& random) { return 1 + random.below((1U << 24U) - 1); }

/// A cube of side 2 round the origin, an octahedron, a square seen from both sides, and nothing.
inline std::vector<PickMesh> few_triangles()
{
    PickMesh box = mesh_of(shapes::box());
    for (glm::vec3& place : box.positions) place = 2.0F * place - 1.0F;
    const PickMesh octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                              {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};
    const PickMesh square{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3}};
    return {box, octahedron, square, PickMesh{}};
}

struct RandomScene {
    PickScene scene;
    glm::ivec2 picture;
    std::vector<glm::ivec2> targets;  ///< the pixel of each thing's middle, as far as it can be picked
    std::size_t square = 0;           ///< the place of the square among the meshes
};

inline bool is_empty(const PickScene& scene, const PickThing& thing)
{
    return scene.meshes[thing.mesh].indices.empty();
}

/// The pixel that a point appears in.
inline glm::ivec2 pixel_of_point(const PickScene& scene, const glm::ivec2& picture, const glm::vec3& point)
{
    const glm::dvec4 clip = glm::dmat4(scene.projection) * glm::dmat4(scene.view) * glm::dvec4(point, 1);
    const glm::dvec2 share(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
    return glm::ivec2(glm::floor(share * glm::dvec2(picture)));
}

/// Few meshes in random order, and a camera anywhere with a frustum off the middle; its near plane is 1 away and its
/// far plane 40. The picture has this size, if one is given.
inline RandomScene empty_scene(Random& random, const glm::ivec2& size)
{
    RandomScene made;
    PickScene& scene = made.scene;
    const std::vector<PickMesh> meshes = few_triangles();
    const auto first = static_cast<std::size_t>(random_up_to(4, random));
    for (std::size_t i = 0; i < meshes.size(); ++i) scene.meshes.push_back(meshes[(first + i) % 4]);
    made.square = (2 + 4 - first) % 4;
    scene.view = glm::rotate(glm::translate(glm::mat4(1), 3.0F * random.in_cube()), random.uniform(0, shapes::turn),
                             random.unit_vector());
    const float aside = random.uniform(-0.1F, 0.1F);
    scene.projection = glm::frustum(-0.5F + aside, 0.5F + aside, -0.4F, 0.5F, 1.0F, 40.0F);
    const int width = 40 + random_up_to(120, random);
    const glm::ivec2 any_size(width, 30 + random_up_to(90, random));
    made.picture = size.x > 0 ? size : any_size;
    return made;
}

/// The things in random order, and where they are aimed at.
inline void finish_scene(RandomScene& made, Random& random)
{
    PickScene& scene = made.scene;
    for (std::size_t i = scene.things.size() - 1; i > 0; --i)
        std::swap(scene.things[i], scene.things[static_cast<std::size_t>(random_up_to(static_cast<int>(i), random))]);
    for (const PickThing& thing : scene.things)
        if (!is_empty(scene, thing))
            made.targets.push_back(pixel_of_point(scene, made.picture, glm::vec3(thing.model[3])));
}

/// Things one behind the other, in random order, some of which cannot be picked, and some of which are empty. All lie
/// between the near plane and the far one.
inline RandomScene random_scene(Random& random, const glm::ivec2& size = glm::ivec2(0))
{
    RandomScene made = empty_scene(random, size);
    PickScene& scene = made.scene;
    const glm::mat4 to_world = glm::inverse(scene.view);
    for (int i = 0; i < 11; ++i) {
        // So far apart that none reaches into the next, and so near in direction that many hide others.
        const float depth = 3 * std::pow(1.26F, static_cast<float>(i));
        const float right = depth * random.uniform(-0.16F, 0.16F);
        const glm::vec3 place(right, depth * random.uniform(-0.14F, 0.18F), -depth);
        glm::mat4 model = glm::rotate(glm::translate(to_world, place), random.uniform(0, 6), random.unit_vector());
        model = glm::scale(model, depth * random.uniform(0.04F, 0.065F) * glm::vec3(1, random.uniform(0.6F, 1), 1));
        // The empty mesh comes behind the square.
        const auto kind = static_cast<std::size_t>(i > 4 && i < 7 ? 1 : 2 + random_up_to(3, random));
        scene.things.push_back({(made.square + kind) % 4, model, i % 4 == 1 ? 0 : random_id(random)});
    }
    finish_scene(made, random);
    return made;
}

/// Squares across the camera's view, like stairs: each covers all but a strip of the one behind it, and 2^-17 of the
/// depth's range lies between two. Of every second one the back is seen.
inline RandomScene layered_scene(Random& random)
{
    RandomScene made = empty_scene(random, glm::ivec2(0));
    const glm::mat4 to_world = glm::inverse(made.scene.view);
    const double first = random.uniform(0.3F, 0.95F);
    const float angle = random.uniform(0, shapes::turn);
    const glm::vec2 step = 0.06F * glm::vec2(std::cos(angle), std::sin(angle));
    for (int i = 0; i < 9; ++i) {
        const double window_depth = first + i * 0x1p-17;
        const auto depth = static_cast<float>(1 / (1 - window_depth * (1 - 1 / 40.0)));
        const glm::vec2 middle = static_cast<float>(i - 4) * step;
        const glm::vec3 place(depth * middle.x, depth * (0.05F + middle.y), -depth);
        const glm::vec3 half = 0.15F * depth * glm::vec3(i % 2 == 0 ? 1 : -1, 1, 1);
        const glm::mat4 model = glm::scale(glm::translate(to_world, place), half);
        made.scene.things.push_back({made.square, model, random_id(random)});
    }
    finish_scene(made, random);
    return made;
}

/// The edges of all that can be picked, in pixels from the picture's upper left corner. For scenes behind the near
/// plane.
class EdgesInPicture {
public:
    EdgesInPicture(const PickScene& scene, const glm::ivec2& picture)
    {
        for (const PickThing& thing : scene.things) {
            if (thing.id == 0) continue;
            const PickMesh& mesh = scene.meshes[thing.mesh];
            const glm::dmat4 all = glm::dmat4(scene.projection) * glm::dmat4(scene.view) * glm::dmat4(thing.model);
            const auto place = [&](std::size_t i) {
                const glm::dvec4 clip = all * glm::dvec4(mesh.positions[mesh.indices[i]], 1);
                return glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * glm::dvec2(picture);
            };
            for (std::size_t i = 0; i < mesh.indices.size(); ++i)
                edges_.push_back({place(i), place(i % 3 == 2 ? i - 2 : i + 1)});
        }
    }

    /// How far the centre of a pixel is from the nearest edge, in pixels.
    [[nodiscard]] double distance(const glm::ivec2& pixel) const
    {
        const glm::dvec2 centre = glm::dvec2(pixel) + 0.5;
        double least = 1000;
        for (const auto& [from, to] : edges_) {
            const glm::dvec2 along = to - from;
            const double squared = dot(along, along);
            const double share = squared > 0 ? std::clamp(dot(centre - from, along) / squared, 0.0, 1.0) : 0.0;
            least = std::min(least, length(centre - from - share * along));
        }
        return least;
    }

private:
    struct Edge {
        glm::dvec2 from;
        glm::dvec2 to;
    };
    std::vector<Edge> edges_;
};

/// Squares that a hand can follow: a picture of 8 x 4 pixels over the whole of OpenGL's cube. The red one, 255, lies
/// before the green one, which is drawn later; the blue one is behind the far plane.
inline PickScene squares_by_hand()
{
    PickScene scene;
    scene.meshes = {few_triangles()[2]};
    const auto placed = [](const glm::vec3& middle, const glm::vec2& half) {
        return glm::scale(glm::translate(glm::mat4(1), middle), glm::vec3(half, 1));
    };
    scene.things = {{0, placed({-0.5F, 0.5F, -0.5F}, {0.5F, 0.5F}), 0x0000FFU},
                    {0, placed({0, 0.5F, 0.5F}, {0.75F, 0.5F}), 0x00FF00U},
                    {0, placed({0.75F, -0.5F, 0}, {0.25F, 0.5F}), 0x010203U},
                    {0, placed({-0.25F, -0.75F, 0.25F}, {0.25F, 0.25F}), 0xFFFFFFU},
                    {0, placed({0.75F, 0.5F, -0.9F}, {0.25F, 0.5F}), 0},
                    {0, placed({-0.75F, -0.5F, 1.5F}, {0.25F, 0.5F}), 0xFF0000U}};
    return scene;
}

}
