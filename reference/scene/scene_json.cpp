#include "scene/scene_json.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"
#include "scene/values.hpp"
#include "text/json_file.hpp"

namespace umbral::scene {
namespace {

glm::vec3 color_or(const Field& field, const glm::vec3& fallback)
{
    return field.given() ? vector3(field, 0, maximum_color) : fallback;
}

glm::vec3 place(const Field& field) { return vector3(field, -maximum_coordinate, maximum_coordinate); }

glm::vec3 direction(const Field& field)
{
    const glm::vec3 value = place(field);
    // Neither may its square vanish, in float.
    if (dot(value, value) < 1e-20F) field.refuse("a direction of length 1e-10 or more");
    return value;
}

Camera parse_camera(const Field& field)
{
    field.allow_only({"eye", "target", "up", "fovy_degrees", "near", "far", "lens_radius", "focus_distance"});
    Camera camera{.eye = place(field.member("eye")),
                  .target = place(field.member("target")),
                  .up = field.member("up").given() ? direction(field.member("up")) : glm::vec3(0, 1, 0),
                  .fovy_degrees = real(field.member("fovy_degrees"), 1, 170),
                  .near = real(field.member("near"), 1e-4, maximum_coordinate),
                  .far = real(field.member("far"), 1e-4, maximum_coordinate)};
    camera.lens_radius = real_or(field.member("lens_radius"), 0, 1000, 0);
    camera.focus_distance = real_or(field.member("focus_distance"), 1e-4, maximum_coordinate, 0);
    if (camera.eye == camera.target) field.member("target").refuse("another place than the eye");
    if (!(camera.far >= 1.01F * camera.near)) field.member("far").refuse("at least 1.01 times near");
    return camera;
}

Light parse_light(const Field& field)
{
    field.allow_only({"name", "position", "towards", "color", "radius", "half_angle_degrees"});
    const Field position = field.member("position");
    const Field towards = field.member("towards");
    if (position.given() == towards.given())
        field.refuse("either \"position\" (a place) or \"towards\" (the direction to a light far away)");
    const Field radius = field.member("radius");
    const Field half_angle = field.member("half_angle_degrees");
    if (radius.given() && !position.given()) radius.refuse("half_angle_degrees in its place for a light far away");
    if (half_angle.given() && position.given())
        half_angle.refuse("radius in its place for a light that has a position");
    return {.name = field.member("name").text(maximum_name_length),
            .positional = position.given(),
            .where = position.given() ? place(position) : direction(towards),
            .color = color_or(field.member("color"), glm::vec3(1)),
            .radius = real_or(radius, 0, maximum_coordinate, 0),
            .half_angle_degrees = real_or(half_angle, 0, 45, 0)};
}

Texture parse_texture(const Field& field)
{
    field.allow_only({"kind", "size", "cells", "colors", "filter", "wrap"});
    Texture texture;
    texture.kind = static_cast<TextureKind>(field.member("kind").one_of({"checker", "stripes", "uv-grid"}));
    texture.size = field.member("size").integer(1, maximum_texture_size);
    texture.cells = field.member("cells").integer(1, maximum_texture_size);
    const Field colors = field.member("colors");
    if (texture.kind == TextureKind::uv_grid) {
        if (colors.given()) colors.refuse("no colors: a uv-grid has its own");
    } else {
        const std::vector<Field> pair = colors.items(2, 2);
        texture.first = vector3(pair[0], 0, 1);
        texture.second = vector3(pair[1], 0, 1);
    }
    texture.bilinear = !field.member("filter").given() || field.member("filter").one_of({"nearest", "bilinear"}) == 1;
    texture.repeat = !field.member("wrap").given() || field.member("wrap").one_of({"clamp", "repeat"}) == 1;
    return texture;
}

Material parse_material(const Field& field, const std::vector<std::string>& textures)
{
    field.allow_only({"emission", "ambient", "diffuse", "specular", "exponent", "texture", "texture_scale", "mirror",
                      "transmit", "index"});
    Material material;
    material.emission = color_or(field.member("emission"), material.emission);
    material.ambient = color_or(field.member("ambient"), material.ambient);
    material.diffuse = color_or(field.member("diffuse"), material.diffuse);
    material.specular = color_or(field.member("specular"), material.specular);
    if (const Field exponent = field.member("exponent"); exponent.given()) material.exponent = real(exponent, 0, 10000);
    if (const Field texture = field.member("texture"); texture.given()) material.texture = texture.one_of(textures);
    if (const Field scale = field.member("texture_scale"); scale.given())
        material.texture_scale = vector2(scale, -1000, 1000);
    if (const Field mirror = field.member("mirror"); mirror.given()) material.mirror = vector3(mirror, 0, 1);
    if (const Field transmit = field.member("transmit"); transmit.given()) material.transmit = vector3(transmit, 0, 1);
    material.index = real_or(field.member("index"), 1, 4, material.index);
    return material;
}

Transform parse_transform(const Field& field)
{
    field.allow_only({"translate", "rotate", "scale"});
    const Field translate = field.member("translate");
    const Field rotate = field.member("rotate");
    const Field scale = field.member("scale");
    if (int{translate.given()} + int{rotate.given()} + int{scale.given()} != 1)
        field.refuse("exactly one of translate, rotate, scale");
    if (translate.given()) return Translate{place(translate)};
    if (rotate.given()) {
        rotate.allow_only({"axis", "degrees"});
        return Rotate{direction(rotate.member("axis")), real(rotate.member("degrees"), -3600, 3600)};
    }
    const Scale factors{vector3(scale, -1000, 1000)};
    if (glm::any(glm::lessThan(glm::abs(factors.by), glm::vec3(1e-4F)))) scale.refuse("factors of size 0.0001 or more");
    return factors;
}

Instance parse_instance(const Field& field, const std::vector<std::string>& geometries,
                        const std::vector<std::string>& materials)
{
    field.allow_only({"name", "geometry", "material", "transforms", "shading", "sides"});
    Instance instance;
    instance.name = field.member("name").text(maximum_name_length);
    instance.geometry = field.member("geometry").one_of(geometries);
    instance.material = field.member("material").one_of(materials);
    if (const Field transforms = field.member("transforms"); transforms.given())
        for (const Field& transform : transforms.items(0, maximum_transforms))
            instance.transforms.push_back(parse_transform(transform));
    instance.smooth = !field.member("shading").given() || field.member("shading").one_of({"flat", "smooth"}) == 1;
    if (const Field sides = field.member("sides"); sides.given())
        instance.sides = static_cast<Sides>(sides.one_of({"front", "both"}));
    return instance;
}

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

template <class Thing>
std::vector<std::string> names_of(const std::vector<Thing>& things)
{
    std::vector<std::string> names;
    std::transform(things.begin(), things.end(), std::back_inserter(names),
                   [](const Thing& thing) { return thing.name; });
    return names;
}

template <class Thing>
void refuse_a_name_twice(const Field& list, const std::vector<Thing>& things)
{
    std::vector<std::string> names = names_of(things);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) list.refuse("every name once, but \"" + *twice + "\" stands twice");
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
    root.allow_only({"format", "version", "title", "camera", "background", "ambient", "bounces", "depth", "lights",
                     "textures", "materials", "geometries", "instances"});
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
    if (const Field bounces = root.member("bounces"); bounces.given()) scene.bounces = bounces.integer(0, 64);
    if (const Field depth = root.member("depth"); depth.given()) scene.depth = depth.integer(0, 64);
    const Field lights = root.member("lights");
    for (const Field& light : lights.items(0, maximum_lights)) scene.lights.push_back(parse_light(light));
    refuse_a_name_twice(lights, scene.lights);

    scene.textures = parse_named(root.member("textures"), parse_texture);
    const std::vector<std::string> textures = names_of(scene.textures);
    scene.materials =
        parse_named(root.member("materials"), [&](const Field& field) { return parse_material(field, textures); });
    scene.geometries = parse_named(root.member("geometries"), [](const Field& field) {
        return Geometry{"", parse_shape(field)};
    });

    const std::vector<std::string> materials = names_of(scene.materials);
    const std::vector<std::string> geometries = names_of(scene.geometries);
    const Field instances = root.member("instances");
    for (const Field& field : instances.items(0, maximum_items)) {
        scene.instances.push_back(parse_instance(field, geometries, materials));
        const Instance& instance = scene.instances.back();
        if (scene.materials[instance.material].texture && !has_uvs(scene.geometries[instance.geometry]))
            field.member("material")
                .refuse("a material without a texture, as geometry \"" + scene.geometries[instance.geometry].name +
                        "\" has no uvs");
    }
    refuse_a_name_twice(instances, scene.instances);
    refuse_too_much(root, scene);
    return scene;
}

}

Scene parse_scene(std::string_view text, const std::string& file) { return parse(Field(parse_json(text, file), file)); }

Scene read_scene(const std::filesystem::path& file)
{
    return parse(Field(read_json(file, maximum_file_bytes), file.string()));
}

}
