#include "scene/scene_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"
#include "scene/values.hpp"
#include "text/json_file.hpp"

namespace umbral::scene {
namespace {

/// A map from names to things becomes a list of things that know their names.
template <class Parse>
auto parse_named(const Field& map, const Parse& parse)
{
    std::vector<decltype(parse(map))> list;
    if (!map.given()) return list;
    for (const auto& [name, field] : map.members(maximum_items)) {
        if (name.empty() || name.size() > maximum_name_length) field.refuse("a name of 1 to 64 bytes");
        list.push_back(parse(field));
        list.back().name = name;
    }
    return list;
}

void refuse_more_than(std::size_t most, std::size_t count, const Field& field, const char* what)
{
    if (count > most)
        field.refuse("at most " + std::to_string(most) + " " + what + " in all, not " + std::to_string(count));
}

void refuse_too_much(const Field& root, const Scene& scene)
{
    std::size_t texels = 0;
    for (const Texture& texture : scene.textures)
        texels += static_cast<std::size_t>(texture.size) * static_cast<std::size_t>(texture.size);
    refuse_more_than(maximum_texels, texels, root.member("textures"), "texels");
    std::size_t stored = 0;
    for (const Geometry& geometry : scene.geometries) stored += triangle_count(geometry.shape);
    refuse_more_than(maximum_triangles, stored, root.member("geometries"), "triangles");
    std::size_t drawn = 0;
    for (const Instance& instance : scene.instances) drawn += triangle_count(scene.geometries[instance.geometry].shape);
    refuse_more_than(maximum_triangles, drawn, root.member("instances"), "triangles");
}

Scene parse(const Field& root)
{
    root.allow_only({"format", "version", "title", "camera", "background", "ambient", "bounces", "depth", "seconds",
                     "lights", "textures", "materials", "geometries", "groups", "instances"});
    (void)root.member("format").one_of({"umbral-scene"});
    (void)root.member("version").integer(1, 1);
    Scene scene;
    if (root.member("title").given()) scene.title = root.member("title").text(200);
    scene.camera = parse_camera(root.member("camera"));
    if (const Field background = root.member("background"); background.given()) {
        background.allow_only({"top", "bottom"});
        scene.background_top = vector3(background.member("top"), 0, 1);
        scene.background_bottom = vector3(background.member("bottom"), 0, 1);
    }
    scene.ambient = color_or(root.member("ambient"), scene.ambient);
    if (const Field bounces = root.member("bounces"); bounces.given())
        scene.bounces = bounces.integer(0, maximum_depth);
    if (const Field depth = root.member("depth"); depth.given()) scene.depth = depth.integer(0, maximum_depth);
    scene.seconds = real_or(root.member("seconds"), 0, maximum_seconds, 0);
    const Field lights = root.member("lights");
    for (const Field& light : lights.items(0, maximum_lights)) scene.lights.push_back(parse_light(light));
    refuse_a_name_twice(lights, names_of(scene.lights));

    scene.textures = parse_named(root.member("textures"), parse_texture);
    const std::vector<std::string> textures = names_of(scene.textures);
    scene.materials =
        parse_named(root.member("materials"), [&](const Field& field) { return parse_material(field, textures); });
    scene.geometries = parse_named(root.member("geometries"), [](const Field& field) {
        return Geometry{"", parse_shape(field)};
    });

    parse_instances(root, scene);
    refuse_too_much(root, scene);
    return scene;
}

}

void refuse_a_name_twice(const Field& list, std::vector<std::string> names)
{
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) list.refuse("every name once, but \"" + *twice + "\" stands twice");
}

Scene parse_scene(std::string_view text, const std::string& file) { return parse(Field(parse_json(text, file), file)); }

Scene read_scene(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json(file, maximum_file_bytes);
    const Field root(json, file.string());
    Scene scene = parse(root);
    read_mesh_files(root.member("geometries"), file.parent_path(), scene);
    refuse_too_much(root, scene);
    return scene;
}

}
