#include "scene/scene_json.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/node.hpp"
#include "scene/parts.hpp"

namespace umbral::scene {
namespace {

glm::vec3 color_or(const Node& node, const glm::vec3& fallback) { return node.given() ? node.vector3(0, maximum_color) : fallback; }

glm::vec3 place(const Node& node) { return node.vector3(-maximum_coordinate, maximum_coordinate); }

glm::vec3 direction(const Node& node)
{
    const glm::vec3 value = place(node);
    // Neither may its square vanish, in float.
    if (dot(value, value) < 1e-20F) node.refuse("a direction of length 1e-10 or more");
    return value;
}

Camera parse_camera(const Node& node)
{
    node.allow_only({"eye", "target", "up", "fovy_degrees", "near", "far"});
    Camera camera{.eye = place(node.member("eye")),
                  .target = place(node.member("target")),
                  .up = node.member("up").given() ? direction(node.member("up")) : glm::vec3(0, 1, 0),
                  .fovy_degrees = node.member("fovy_degrees").number(1, 170),
                  .near = node.member("near").number(1e-4, maximum_coordinate),
                  .far = node.member("far").number(1e-4, maximum_coordinate)};
    if (camera.eye == camera.target) node.member("target").refuse("another place than the eye");
    if (!(camera.far >= 1.01F * camera.near)) node.member("far").refuse("at least 1.01 times near");
    return camera;
}

Light parse_light(const Node& node)
{
    node.allow_only({"name", "position", "towards", "color"});
    const Node position = node.member("position");
    const Node towards = node.member("towards");
    if (position.given() == towards.given()) node.refuse("either \"position\" (a place) or \"towards\" (the direction to a light far away)");
    return {.name = node.member("name").text(maximum_name_length),
            .positional = position.given(),
            .where = position.given() ? place(position) : direction(towards),
            .color = color_or(node.member("color"), glm::vec3(1))};
}

Texture parse_texture(const Node& node)
{
    node.allow_only({"kind", "size", "cells", "colors", "filter", "wrap"});
    Texture texture;
    texture.kind = static_cast<TextureKind>(node.member("kind").one_of({"checker", "stripes", "uv-grid"}));
    texture.size = node.member("size").integer(1, maximum_texture_size);
    texture.cells = node.member("cells").integer(1, maximum_texture_size);
    const Node colors = node.member("colors");
    if (texture.kind == TextureKind::uv_grid) {
        if (colors.given()) colors.refuse("no colors: a uv-grid has its own");
    } else {
        const std::vector<Node> pair = colors.items(2, 2);
        texture.first = pair[0].vector3(0, 1);
        texture.second = pair[1].vector3(0, 1);
    }
    texture.bilinear = !node.member("filter").given() || node.member("filter").one_of({"nearest", "bilinear"}) == 1;
    texture.repeat = !node.member("wrap").given() || node.member("wrap").one_of({"clamp", "repeat"}) == 1;
    return texture;
}

Material parse_material(const Node& node, const std::vector<std::string>& textures)
{
    node.allow_only({"emission", "ambient", "diffuse", "specular", "exponent", "texture", "texture_scale"});
    Material material;
    material.emission = color_or(node.member("emission"), material.emission);
    material.ambient = color_or(node.member("ambient"), material.ambient);
    material.diffuse = color_or(node.member("diffuse"), material.diffuse);
    material.specular = color_or(node.member("specular"), material.specular);
    if (const Node exponent = node.member("exponent"); exponent.given()) material.exponent = exponent.number(0, 10000);
    if (const Node texture = node.member("texture"); texture.given()) material.texture = texture.one_of(textures);
    if (const Node scale = node.member("texture_scale"); scale.given()) material.texture_scale = scale.vector2(-1000, 1000);
    return material;
}

Transform parse_transform(const Node& node)
{
    node.allow_only({"translate", "rotate", "scale"});
    const Node translate = node.member("translate");
    const Node rotate = node.member("rotate");
    const Node scale = node.member("scale");
    if (int{translate.given()} + int{rotate.given()} + int{scale.given()} != 1) node.refuse("exactly one of translate, rotate, scale");
    if (translate.given()) return Translate{place(translate)};
    if (rotate.given()) {
        rotate.allow_only({"axis", "degrees"});
        return Rotate{direction(rotate.member("axis")), rotate.member("degrees").number(-3600, 3600)};
    }
    const Scale factors{scale.vector3(-1000, 1000)};
    if (glm::any(glm::lessThan(glm::abs(factors.by), glm::vec3(1e-4F)))) scale.refuse("factors of size 0.0001 or more");
    return factors;
}

Instance parse_instance(const Node& node, const std::vector<std::string>& geometries, const std::vector<std::string>& materials)
{
    node.allow_only({"name", "geometry", "material", "transforms", "shading", "sides"});
    Instance instance;
    instance.name = node.member("name").text(maximum_name_length);
    instance.geometry = node.member("geometry").one_of(geometries);
    instance.material = node.member("material").one_of(materials);
    if (const Node transforms = node.member("transforms"); transforms.given())
        for (const Node& transform : transforms.items(0, maximum_transforms)) instance.transforms.push_back(parse_transform(transform));
    instance.smooth = !node.member("shading").given() || node.member("shading").one_of({"flat", "smooth"}) == 1;
    if (const Node sides = node.member("sides"); sides.given()) instance.sides = static_cast<Sides>(sides.one_of({"front", "both"}));
    return instance;
}

/// A map from names to things becomes a list of things that know their names.
template <class Parse>
auto parse_named(const Node& map, const Parse& parse)
{
    std::vector<decltype(parse(map))> list;
    if (!map.given()) return list;
    for (const auto& [name, node] : map.members(maximum_items)) {
        if (name.empty() || name.size() > maximum_name_length) node.refuse("a name of 1 to 64 bytes");
        list.push_back(parse(node));
        list.back().name = name;
    }
    return list;
}

template <class Thing>
std::vector<std::string> names_of(const std::vector<Thing>& things)
{
    std::vector<std::string> names;
    std::transform(things.begin(), things.end(), std::back_inserter(names), [](const Thing& thing) { return thing.name; });
    return names;
}

template <class Thing>
void refuse_a_name_twice(const Node& list, const std::vector<Thing>& things)
{
    std::vector<std::string> names = names_of(things);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) list.refuse("every name once, but \"" + *twice + "\" stands twice");
}

void refuse_more_than(std::size_t most, std::size_t count, const Node& node, const char* what)
{
    if (count > most) node.refuse("at most " + std::to_string(most) + " " + what + " in all, not " + std::to_string(count));
}

void refuse_too_much(const Node& root, const Scene& scene)
{
    std::size_t texels = 0;
    for (const Texture& texture : scene.textures) texels += static_cast<std::size_t>(texture.size) * static_cast<std::size_t>(texture.size);
    refuse_more_than(maximum_texels, texels, root.member("textures"), "texels");
    std::size_t stored = 0;
    for (const Geometry& geometry : scene.geometries) stored += triangle_count(geometry.shape);
    refuse_more_than(maximum_triangles, stored, root.member("geometries"), "triangles");
    std::size_t drawn = 0;
    for (const Instance& instance : scene.instances) drawn += triangle_count(scene.geometries[instance.geometry].shape);
    refuse_more_than(maximum_triangles, drawn, root.member("instances"), "triangles");
}

Scene parse(const Node& root)
{
    root.allow_only({"format", "version", "title", "camera", "background", "ambient", "lights", "textures", "materials", "geometries", "instances"});
    (void)root.member("format").one_of({"umbral-scene"});
    (void)root.member("version").integer(1, 1);
    Scene scene;
    if (root.member("title").given()) scene.title = root.member("title").text(200);
    scene.camera = parse_camera(root.member("camera"));
    if (const Node background = root.member("background"); background.given()) {
        background.allow_only({"top", "bottom"});
        scene.background_top = background.member("top").vector3(0, 1);
        scene.background_bottom = background.member("bottom").vector3(0, 1);
    }
    scene.ambient = color_or(root.member("ambient"), scene.ambient);
    const Node lights = root.member("lights");
    for (const Node& light : lights.items(0, maximum_lights)) scene.lights.push_back(parse_light(light));
    refuse_a_name_twice(lights, scene.lights);

    scene.textures = parse_named(root.member("textures"), parse_texture);
    const std::vector<std::string> textures = names_of(scene.textures);
    scene.materials = parse_named(root.member("materials"), [&](const Node& node) { return parse_material(node, textures); });
    scene.geometries = parse_named(root.member("geometries"), [](const Node& node) { return Geometry{"", parse_shape(node)}; });

    const std::vector<std::string> materials = names_of(scene.materials);
    const std::vector<std::string> geometries = names_of(scene.geometries);
    const Node instances = root.member("instances");
    for (const Node& node : instances.items(0, maximum_items)) {
        scene.instances.push_back(parse_instance(node, geometries, materials));
        const Instance& instance = scene.instances.back();
        if (scene.materials[instance.material].texture && !has_uvs(scene.geometries[instance.geometry]))
            node.member("material").refuse("a material without a texture, as geometry \"" + scene.geometries[instance.geometry].name + "\" has no uvs");
    }
    refuse_a_name_twice(instances, scene.instances);
    refuse_too_much(root, scene);
    return scene;
}

}

Scene parse_scene(std::string_view text, const std::string& file) { return parse(Node(parse_json_text(text, file), file)); }

Scene read_scene(const std::filesystem::path& file) { return parse(Node(read_json_file(file, maximum_file_bytes), file.string())); }

}
