// The parts of a scene's file that say how it is seen: camera, lights, textures, materials.

#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"
#include "scene/values.hpp"

namespace umbral::scene {

Camera parse_camera(const Field& field)
{
    field.allow_only(
        {"eye", "target", "up", "fovy_degrees", "near", "far", "lens_radius", "focus_distance", "shutter_seconds"});
    Camera camera{.eye = place(field.member("eye")),
                  .target = place(field.member("target")),
                  .up = field.member("up").given() ? direction(field.member("up")) : glm::vec3(0, 1, 0),
                  .fovy_degrees = real(field.member("fovy_degrees"), 1, 170),
                  .near = real(field.member("near"), 1e-4, maximum_coordinate),
                  .far = real(field.member("far"), 1e-4, maximum_coordinate),
                  .lens_radius = real_or(field.member("lens_radius"), 0, 1000, 0),
                  .focus_distance = real_or(field.member("focus_distance"), 1e-4, maximum_coordinate, 0),
                  .shutter_seconds = real_or(field.member("shutter_seconds"), 0, 3600, 0)};
    if (camera.eye == camera.target) field.member("target").refuse("another place than the eye");
    if (!(camera.far >= 1.01F * camera.near)) field.member("far").refuse("at least 1.01 times near");
    return camera;
}

Light parse_light(const Field& field)
{
    field.allow_only({"name", "position", "towards", "color", "radius", "half_angle_degrees"});
    const Field position = field.member("position");
    const Field towards = field.member("towards");
    const Field radius = field.member("radius");
    const Field half_angle = field.member("half_angle_degrees");
    if (position.given() == towards.given())
        field.refuse("either \"position\" (a place) or \"towards\" (the direction to a light far away)");
    if (radius.given() && !position.given()) radius.refuse("half_angle_degrees in its place for a light far away");
    if (half_angle.given() && !towards.given())
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
    texture.kind = static_cast<TextureKind>(
        field.member("kind").one_of({"checker", "stripes", "uv-grid", "wood", "marble", "bricks", "pores"}));
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
                      "transmit", "index", "bump", "bump_height"});
    Material material;
    material.emission = color_or(field.member("emission"), material.emission);
    material.ambient = color_or(field.member("ambient"), material.ambient);
    material.diffuse = color_or(field.member("diffuse"), material.diffuse);
    material.specular = color_or(field.member("specular"), material.specular);
    material.exponent = real_or(field.member("exponent"), 0, 10000, material.exponent);
    if (const Field texture = field.member("texture"); texture.given()) material.texture = texture.one_of(textures);
    if (const Field scale = field.member("texture_scale"); scale.given())
        material.texture_scale = vector2(scale, -1000, 1000);
    material.mirror = color_or(field.member("mirror"), material.mirror, 1);
    material.transmit = color_or(field.member("transmit"), material.transmit, 1);
    material.index = real_or(field.member("index"), 1, 4, material.index);
    const Field bump = field.member("bump");
    const Field height = field.member("bump_height");
    if (bump.given() != height.given())
        field.refuse("\"bump\" (a texture of heights) and \"bump_height\" (how far they reach) together");
    if (bump.given()) material.bump = bump.one_of(textures);
    material.bump_height = real_or(height, -1000, 1000, 0);
    return material;
}

}
