#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <umbral/raytracing/bounding_volumes.hpp>

#include "../ball_scene.hpp"
#include "../study.hpp"

namespace umbral::bench {
namespace {

using raytracing::BoundingBox;
using raytracing::Triangle;

/// A tree of boxes, halved at the median of the centres along the box's longest side, with leaves of bounded size.
struct Tree {
    struct Node {
        BoundingBox box;
        std::size_t first;  ///< of a leaf's triangles
        std::size_t count;  ///< 0: an inner node, whose right child is `right`; the left one follows it
        std::size_t right;
    };
    std::vector<Triangle> triangles;
    std::vector<Node> nodes;
};

void build(Tree& tree, std::size_t first, std::size_t count, std::size_t leaf)
{
    const auto begin = tree.triangles.begin() + static_cast<std::ptrdiff_t>(first);
    const BoundingBox box = raytracing::bounding_box(std::span(tree.triangles).subspan(first, count));
    const std::size_t node = tree.nodes.size();
    tree.nodes.push_back({box, first, count <= leaf ? count : 0, 0});
    if (count <= leaf) return;
    const glm::vec3 size = box.high - box.low;
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const auto key = [axis](const Triangle& one) { return one.v0[axis] + one.v1[axis] + one.v2[axis]; };
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count / 2), begin + static_cast<std::ptrdiff_t>(count),
                     [&](const Triangle& a, const Triangle& b) { return key(a) < key(b); });
    build(tree, first, count / 2, leaf);
    tree.nodes[node].right = tree.nodes.size();
    build(tree, first + count / 2, count - count / 2, leaf);
}

void search(const Tree& tree, std::size_t at, Ray& ray)
{
    const Tree::Node& node = tree.nodes[at];
    if (!raytracing::meets_box(ray, node.box)) return;
    if (node.count == 0) {
        search(tree, at + 1, ray);
        search(tree, node.right, ray);
        return;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i)
        if (const auto hit = raytracing::intersect(ray, tree.triangles[i])) ray.t_max = hit->t;
}

}

Knob measure_leaf_size(Means& means)
{
    constexpr std::uint64_t seed = 24;
    Study study = study_of("leaf-size", "Triangles in a leaf",
                           fmt::format("A hierarchy of a ball's 32 512 triangles, halved until a leaf has at most so "
                                       "many: memory of the boxes against the time of a ray; answers are the same. "
                                       "Seed {}.",
                                       seed),
                           "ns per ray", {{"memory", "memory of the tree", "bytes per triangle"}});
    Random random(seed);
    const std::vector<Ray> rays = rays_at_ball(200, random);
    for (const std::size_t leaf : {1U, 2U, 4U, 8U, 16U, 32U, 64U}) {
        const auto tree = std::make_shared<Tree>();
        tree->triangles = ball_triangles(128);
        build(*tree, 0, tree->triangles.size(), leaf);
        const double memory =
            static_cast<double>(tree->nodes.size() * sizeof(Tree::Node)) / static_cast<double>(tree->triangles.size());
        study.trials.push_back({fmt::format("leaves of {}", leaf),
                                "leaves",
                                static_cast<double>(leaf),
                                {{"memory", memory}},
                                static_cast<double>(rays.size()),
                                [tree, rays] {
                                    for (Ray ray : rays) {
                                        search(*tree, 0, ray);
                                        keep(ray);
                                    }
                                }});
    }
    study.laws = {{"leaves", "memory", "triangles in a leaf", -1, "A tree has twice as many nodes as leaves.",
                   "Halving n does not end at full leaves."}};
    return finish(std::move(study), means);
}

}
