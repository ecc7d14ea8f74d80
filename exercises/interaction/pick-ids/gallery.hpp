#pragma once

#include <array>
#include <kit/stage.hpp>
#include <umbral/record/ask.hpp>

#include "../arrow.hpp"
#include "scenes.hpp"

/// The goal picture: the same scene in light and in identifiers, and what the cursor picks.
namespace umbral::interaction {

/// Something to show and to pick. Ids are colours that can be told apart: blue, green, red, from the highest byte.
struct Exhibit {
    std::size_t shape;
    glm::mat4 model;
    Finish finish;
    std::uint32_t id;
};

inline glm::mat4 standing(const glm::vec3& place, float size, float turned = 0)
{
    return glm::scale(glm::rotate(glm::translate(glm::mat4(1), place), turned, glm::vec3(0, 1, 0)), glm::vec3(size));
}

inline std::vector<Exhibit> exhibits()
{
    const auto color = [](float hue) { return glm::vec3(srgb_decoded(glm::dvec3(rainbow(hue, 0.55F, 0.9F)))); };
    const glm::mat4 upright = glm::rotate(glm::mat4(1), shapes::turn / 4, glm::vec3(1, 0, 0));
    std::vector<Exhibit> all = {
        {0, standing({-1.75F, 0.95F, -0.5F}, 0.30F, 0.5F), {color(0.08F), 0.6F}, 0x3C8CFFU},
        {1, standing({0.15F, 0.85F, 0.1F}, 0.62F, 0.35F) * upright, {color(0.55F), 0.6F}, 0xE6C850U},
        {2, standing({0.15F, 0.85F, 0.1F}, 0.30F), {color(0.98F), 0.6F}, 0x7846F0U},
        {3, standing({1.15F, 0, -0.9F}, 0.9F, 0.4F), {color(0.33F), 0.3F}, 0x5AD25AU},
        {2, standing({1.52F, 1.22F, -0.62F}, 0.32F), {color(0.72F), 0.6F}, 0xC846B4U},
        {2, standing({-0.85F, 0.22F, 0.95F}, 0.22F), {color(0.14F), 0.6F}, 0x28DCF0U},
        {3, standing({1.2F, 0, 0.55F}, 0.34F, -0.4F), {color(0.02F), 0.3F}, 0x4646E6U},
        {1, standing({-0.35F, 0.37F, 1.35F}, 0.3F), {color(0.45F), 0.5F}, 0xB4A03CU},
        {2, standing({0.62F, 0.15F, 1.35F}, 0.15F), {color(0.62F), 0.6F}, 0xFF8C64U}};
    return all;
}

inline const std::array<shapes::Shape, 4>& exhibit_shapes()
{
    static const std::array<shapes::Shape, 4> all = {shapes::trefoil(200, 24, 0.42F), shapes::torus(64, 24, 0.22F),
                                                     shapes::icosphere(4), shapes::box()};
    return all;
}

constexpr glm::vec3 gallery_eye{0.9F, 2.35F, 5.6F};
constexpr glm::vec3 gallery_target{0.02F, 0.62F, 0};
constexpr float gallery_fovy_degrees = 31;

inline PickScene gallery_scene(float aspect)
{
    PickScene scene;
    scene.view = glm::lookAt(gallery_eye, gallery_target, glm::vec3(0, 1, 0));
    scene.projection = glm::perspective(glm::radians(gallery_fovy_degrees), aspect, 0.1F, 100.0F);
    for (const shapes::Shape& shape : exhibit_shapes()) scene.meshes.push_back(mesh_of(shape));
    for (const Exhibit& one : exhibits()) scene.things.push_back({one.shape, one.model, one.id});
    return scene;
}

inline Image gallery_in_light(int width, int height)
{
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const Stage stage(width, height, glm::vec3(0.17F, 0.20F, 0.29F));
    stage.look(gallery_eye, gallery_target, gallery_fovy_degrees, aspect);
    std::vector<std::unique_ptr<gl::Mesh>> meshes;
    for (const shapes::Shape& shape : exhibit_shapes())
        meshes.push_back(std::make_unique<gl::Mesh>(shape.positions, shape.normals, shape.indices));
    const gl::Mesh ground = uploaded(shapes::box());
    std::vector<Stage::Thing> things;
    for (const Exhibit& one : exhibits()) things.push_back({*meshes[one.shape], one.model, one.finish});
    stage.draw_on({ground, slab(9), {glm::vec3(0.30F, 0.33F, 0.40F), 0, glm::vec3(0.20F, 0.22F, 0.29F), 0.02F}},
                  things);
    return stage.picture();
}

/// On the left the picture that everybody sees, on the right the invisible one of ids, and the outline of what is
/// picked: of the ids near the cursor, which points beside a thin ring, the nearest.
inline Image gallery(Recorder& out, int width, int height)
{
    const Image lit = gallery_in_light(width, height);
    const PickScene scene = gallery_scene(static_cast<float>(width) / static_cast<float>(height));
    const std::unique_ptr<IdPicker> picker = ask_new<make_id_picker>(out, "picker");
    const glm::ivec2 large = 2 * glm::ivec2(width, height);
    const glm::ivec2 cursor(large.x * 420 / 960, large.y * 422 / 640);
    if (!picker) return lit;
    const int radius = large.x / 2;
    const Grid<std::uint32_t> ids = ask<&IdPicker::ids_around>(out, *picker, scene, large, large / 2, radius);
    const Grid<std::uint32_t> near = ask<&IdPicker::ids_around>(out, *picker, scene, large, cursor, 12);
    const std::uint32_t picked = ask<nearest_id>(out, near);
    const glm::ivec2 shift = radius - large / 2;
    const auto id_at = [&](const glm::ivec2& at) {
        const glm::ivec2 cell = at + shift;
        return ids.contains(cell.x, cell.y) ? ids.at(cell.x, cell.y) : 0U;
    };
    const auto is_outline = [&](const glm::ivec2& at) {
        if (picked == 0 || id_at(at) == picked) return false;
        for (int k = 0; k < 16; ++k) {
            const float angle = shapes::turn * static_cast<float>(k) / 16;
            if (id_at(at + glm::ivec2(glm::round(5.0F * glm::vec2(std::cos(angle), std::sin(angle))))) == picked)
                return true;
        }
        return false;
    };
    Grid<glm::vec3> light(large.x, large.y);
    for (int y = 0; y < large.y; ++y)
        for (int x = 0; x < large.x; ++x) {
            const glm::ivec2 at(x, y);
            const float from_border = static_cast<float>(x) - 0.60F * static_cast<float>(large.x) +
                                      0.22F * (static_cast<float>(y) - 0.5F * static_cast<float>(large.y));
            glm::vec3 color = glm::vec3(lit.at(x / 2, y / 2)) / 255.0F;
            if (from_border > 0) {
                const std::uint32_t id = id_at(at);
                const glm::vec3 bytes(id & 0xFFU, (id >> 8U) & 0xFFU, (id >> 16U) & 0xFFU);
                color = id == 0 ? glm::vec3(0.015F) : bytes / 255.0F;
            }
            if (std::abs(from_border) < 2) color = glm::vec3(0.95F);
            if (is_outline(at)) color = glm::vec3(1.0F, 0.78F, 0.22F);
            light.at(x, y) = glm::vec3(srgb_decoded(glm::dvec3(color)));
        }
    Image picture = halved(encoded(light));
    paint_arrow(picture, glm::vec2(cursor) / 2.0F, 22);
    return picture;
}

}
