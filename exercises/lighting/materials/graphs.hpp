#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "../random.hpp"
#include "recording.hpp"

/// Graphs to draw, with materials that the unit made.
namespace umbral::lighting {

using Kind = GraphEntry::Kind;

/// What a material is made from.
struct Recipe {
    Material reflection;
    std::shared_ptr<SharedTexture> texture;
};

/// No two of its colours are alike. Of three materials one has numbers from the ends of what is allowed.
inline Material any_material(Random& random)
{
    Material material = random_material(random);
    const std::uint32_t kind = random.below(9);
    if (kind == 0) material.emission *= 40.0F;
    if (kind == 1) material.shininess = random.below(2) == 0 ? 0 : random.uniform(0, 1);
    if (kind == 2) material.shininess = random.below(2) == 0 ? 10'000 : random.uniform(128, 9000);
    return material;
}

/// The same but for one of the five values.
inline Material with_one_other_value(Material material, Random& random)
{
    const Material other = random_material(random);
    switch (random.below(5)) {
        case 0: material.emission = other.emission; break;
        case 1: material.ambient = other.ambient; break;
        case 2: material.diffuse = other.diffuse; break;
        case 3: material.specular = other.specular; break;
        default: material.shininess = other.shininess + 0.5F;
    }
    return material;
}

/// Materials that are all different, every second one with a texture; of the textures two materials share each. Of each
/// four the second and, from the fifth material on, the first have an earlier one's reflection, so that they differ
/// from it in the texture alone; the fourth differs from the second in one value alone.
inline std::vector<Recipe> recipes(Random& random, std::uint32_t count)
{
    std::vector<Recipe> all;
    std::shared_ptr<SharedTexture> texture;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i % 4 == 0) texture = std::make_shared<NamedTexture>(1 + i);
        Material reflection = any_material(random);
        if (i % 4 == 1) reflection = all[i - 1].reflection;
        if (i % 4 == 0 && i > 0) reflection = all[i - 2].reflection;
        if (i % 4 == 3) reflection = with_one_other_value(all[i - 2].reflection, random);
        all.push_back({reflection, i % 2 == 0 ? texture : nullptr});
    }
    return all;
}

/// The materials by the unit; empty if it makes none.
inline std::vector<std::shared_ptr<const SurfaceMaterial>> made(const std::vector<Recipe>& all)
{
    std::vector<std::shared_ptr<const SurfaceMaterial>> materials;
    for (const auto& [reflection, texture] : all) materials.push_back(make_material(reflection, texture));
    for (const auto& material : materials)
        if (!material) return {};
    return materials;
}

/// Four materials, and nodes whose right picture follows by hand: a material that is changed within a node, one that
/// ends with its node and is named again behind it, a node that has none of its own, entered below two, ones that end
/// with a transformation and with a material.
inline MaterialGraph graph_by_hand()
{
    MaterialGraph graph;
    graph.transformations = {glm::translate(glm::mat4(1), {1, 2, 3}), glm::scale(glm::mat4(1), {2, 2, 2})};
    graph.nodes = {{{Kind::object, 10},
                    {Kind::material, 1},
                    {Kind::object, 11},
                    {Kind::node, 1},
                    {Kind::object, 12},
                    {Kind::material, 0},
                    {Kind::object, 15},
                    {Kind::material, 3},
                    {Kind::object, 14},
                    {Kind::material, 1},
                    {Kind::node, 2},
                    {Kind::material, 2},
                    {Kind::node, 2},
                    {Kind::object, 13}},
                   {{Kind::transformation, 0},
                    {Kind::object, 20},
                    {Kind::material, 2},
                    {Kind::object, 21},
                    {Kind::material, 3},
                    {Kind::object, 22},
                    {Kind::transformation, 1},
                    {Kind::object, 23},
                    {Kind::material, 0}},
                   {{Kind::object, 30}, {Kind::transformation, 1}, {Kind::node, 3}, {Kind::object, 31}},
                   {{Kind::material, 0}, {Kind::object, 40}, {Kind::transformation, 0}}};
    return graph;
}

/// Up to a dozen nodes that enter only later ones, at random; some are empty, some are entered several times, and they
/// end with entries of all kinds. The same material is there twice.
inline MaterialGraph random_graph(Random& random, std::uint32_t materials)
{
    MaterialGraph graph;
    for (int i = 0; i < 5; ++i)
        graph.transformations.push_back(
            glm::scale(glm::rotate(glm::translate(glm::mat4(1), 2.0F * random.in_cube()), random.uniform(0, turn),
                                   random.unit_vector()),
                       glm::vec3(random.uniform(0.7F, 1.4F), random.uniform(0.7F, 1.4F), -random.uniform(0.7F, 1.4F))));
    const std::uint32_t count = 6 + random.below(6);
    graph.root = random.below(2);
    for (std::uint32_t node = 0; node < count; ++node) {
        std::vector<GraphEntry> entries;
        const std::uint32_t size = node == graph.root ? 10 : random.below(9);
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t what = random.below(8);
            const std::uint32_t left = count - 1 - node;
            if (what < 3 || (what < 5 && left == 0))
                entries.push_back({Kind::object, random.below(i % 2 == 0 ? 1000 : 10'000'000)});
            else if (what < 5)
                entries.push_back({Kind::node, node + 1 + random.below(std::min(left, 3U))});
            else if (what < 7)
                entries.push_back({Kind::material, random.below(materials)});
            else
                entries.push_back({Kind::transformation, random.below(5)});
        }
        const std::uint32_t end = random.below(4);
        if (end == 0) entries.push_back({Kind::transformation, random.below(5)});
        if (end == 1) entries.push_back({Kind::material, random.below(materials)});
        if (end > 1 || node == graph.root) entries.push_back({Kind::object, 1000 + node});
        graph.nodes.push_back(entries);
    }
    return graph;
}

/// Nodes within nodes, each with a material of its own before what it enters, and an object behind it.
inline MaterialGraph deep_graph(std::uint32_t depth, std::uint32_t materials)
{
    MaterialGraph graph;
    graph.transformations = {glm::translate(glm::mat4(1), {0.25F, 0, 0})};
    for (std::uint32_t i = 0; i < depth; ++i) {
        graph.nodes.push_back({{Kind::material, i % materials}, {Kind::transformation, 0}});
        if (i + 1 < depth) graph.nodes.back().push_back({Kind::node, i + 1});
        graph.nodes.back().push_back({Kind::object, i});
    }
    return graph;
}

/// "0: object 10, material 1, node 2", a line for each node.
inline std::string code_of(const MaterialGraph& graph)
{
    constexpr std::array names = {"object ", "node ", "transformation ", "material "};
    std::string text = "// a graph of these nodes, its root " + std::to_string(graph.root) + ":\n";
    for (std::size_t i = 0; i < graph.nodes.size() && i < 40; ++i) {
        text += "//   " + std::to_string(i) + ":";
        for (const auto& [kind, index] : graph.nodes[i])
            text += std::string(&kind == &graph.nodes[i].front().kind ? " " : ", ") +
                    names[static_cast<std::size_t>(kind)] + std::to_string(index);
        text += "\n";
    }
    return text + "draw_graph(graph, context);";
}

}
