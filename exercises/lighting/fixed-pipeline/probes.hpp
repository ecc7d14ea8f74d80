#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <span>
#include <umbral/lighting/fixed_pipeline.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../linear_frame.hpp"
#include "state.hpp"

/// Single vertices, each seen as one pixel: what the light model gives, without interpolation.
namespace umbral::lighting {

/// A vertex, in eye coordinates, and what lights it.
struct Probe {
    glm::vec3 position{0};
    glm::vec3 normal{0, 0, 1};
    Material material;
    FrameLighting lighting;
    glm::mat4 view{1};
    glm::mat4 modelview{1};  ///< through which position and normal come
    bool seen_from_behind = false;
};

/// Draws one pixel of a frame of 1 x 1.
inline void draw_pixel(const Probe& probe)
{
    // Clip coordinates from the object's: whatever the vertex's place, the pixel is covered.
    glm::mat4 to_centre(0);
    to_centre[3] = {0, 0, 0, 1};
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(to_centre));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(probe.modelview));
    const glm::vec3 position(inverse(probe.modelview) * glm::vec4(probe.position, 1));
    const glm::vec3 normal = transpose(glm::mat3(probe.modelview)) * probe.normal;
    // A normal between glBegin and glEnd, as in draw_back: Mesa compiles another program for one that stands before.
    glBegin(GL_POINTS);
    glNormal3fv(glm::value_ptr(normal));
    glVertex3fv(glm::value_ptr(position));
    glEnd();
}

/// The same vertex as the last one of a triangle of which the back is seen; the others have other normals.
inline void draw_back(const Probe& probe)
{
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glMatrixMode(GL_PROJECTION);
    // Eye coordinates near the vertex, magnified to the whole pixel and beyond.
    glm::mat4 magnified = glm::scale(glm::mat4(1), glm::vec3(2000, 2000, 0));
    magnified = glm::translate(magnified, -probe.position);
    glLoadMatrixf(glm::value_ptr(magnified));
    glFrontFace(GL_CCW);
    glBegin(GL_TRIANGLES);
    for (const glm::vec2 aside : {glm::vec2(0, 0.003F), glm::vec2(0.003F, -0.002F), glm::vec2(-0.003F, -0.002F)}) {
        glNormal3fv(glm::value_ptr(probe.normal));
        glVertex3f(probe.position.x + aside.x, probe.position.y + aside.y, probe.position.z);
    }
    glEnd();
}

/// The light of one vertex. Whatever the state was, the unit's two functions set it.
inline glm::vec3 light_of(Recorder& out, const LinearFrame& frame, const Probe& probe)
{
    ask<set_lighting>(out, probe.lighting, probe.view);
    ask<set_material>(out, probe.material);
    frame.clear();
    probe.seen_from_behind ? draw_back(probe) : draw_pixel(probe);
    return frame.light().at(0, 0);
}

/// A camera anywhere: it turns and moves.
inline glm::mat4 random_view(Random& random)
{
    return glm::rotate(glm::translate(glm::mat4(1), 4.0F * random.in_cube()), random.uniform(0, turn),
                       random.unit_vector());
}

/// Lights of which most reach the place, in the world's coordinates or in the camera's: places and directions by turns,
/// since Mesa compiles a program for each pattern of them.
inline std::vector<PlacedLight> random_lights(Random& random, const SurfacePoint& at, const glm::mat4& view,
                                              std::uint32_t count)
{
    std::vector<PlacedLight> lights;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 direction = at.normal + 1.2F * random.unit_vector();
        PlacedLight placed{light_towards(at, direction, i % 2 == 0, random.uniform(0.5F, 4)),
                           coin(random) ? LightFrame::world : LightFrame::camera};
        placed.light.color = random_color(random);
        if (placed.frame == LightFrame::world) placed.light.position = inverse(view) * placed.light.position;
        lights.push_back(placed);
    }
    return lights;
}

/// Places and directions in any order, of which some are bright and some are out: for what is read and not drawn.
inline std::vector<PlacedLight> lights_of_all_kinds(Random& random, const glm::mat4& view, std::uint32_t count)
{
    std::vector<PlacedLight> lights = random_lights(random, {}, view, count);
    for (auto& [light, frame] : lights) {
        light.position.w = coin(random) ? 1 : 0;
        light.color *= std::array{0.0F, 1.0F, 1.0F, 4.0F}[random.below(4)];
    }
    return lights;
}

/// Anything that a material may be: of two one reflects nothing of one kind or sends out nothing, of four one sends out
/// more than 1, and exponents may be 0, and more than OpenGL knows.
inline Material random_extreme_material(Random& random)
{
    Material material = random_material(random);
    glm::vec3* const parts[] = {&material.emission, &material.ambient, &material.diffuse, &material.specular};
    if (coin(random)) *parts[random.below(4)] = glm::vec3(0);
    if (random.below(4) == 0) material.emission *= 8;
    const float exponents[] = {0, random.uniform(0, 2), random.uniform(2, 128), std::exp2(random.uniform(7, 13))};
    material.shininess = exponents[random.below(4)];
    return material;
}

/// Mesa compiles a program for each number of lights, with either viewer, and for the exponent 0: few of these here,
/// and one alone for 8 lights, which takes the most time.
inline Probe random_probe(Random& random)
{
    Probe probe;
    probe.position = 2.0F * random.in_cube() + glm::vec3(0, 0, -5);
    probe.normal = normalize(0.8F * random.unit_vector() - normalize(probe.position));
    probe.material = random_extreme_material(random);
    probe.material.shininess = std::max(probe.material.shininess, 0.5F);
    probe.view = random_view(random);
    const glm::vec3 size(random.uniform(0.4F, 2.5F), random.uniform(0.4F, 2.5F), random.uniform(0.4F, 2.5F));
    probe.modelview = glm::scale(random_view(random), size);
    const std::uint32_t count = std::array{0U, 2U, 2U, 8U}[random.below(4)];
    probe.lighting = {random_lights(random, {probe.position, probe.normal}, probe.view, count), random_color(random),
                      count != 2 || coin(random), false};
    for (PlacedLight& placed : probe.lighting.lights)
        if (random.below(4) == 0) placed.light.color *= 4;
    probe.seen_from_behind = random.below(3) == 0;
    if (probe.seen_from_behind) probe.normal = -probe.normal;
    return probe;
}

/// A vertex straight ahead, in one white light; values that follow without a calculator. Varied, of other colours.
inline std::vector<Probe> probes_by_hand(Variation vary = {})
{
    std::vector<Probe> probes;
    const auto add = [&](const glm::vec4& light, float e, bool local_viewer, const glm::vec3& position,
                         const glm::vec3& normal) {
        Probe probe;
        probe.position = position;
        probe.normal = normal;
        probe.material = {{0.05F, 0, 0.1F},
                          vary.near(glm::vec3(0.1F), 0.1F),
                          vary.near(glm::vec3(0.5F, 0.25F, 0), 0.2F),
                          vary.near(glm::vec3(0.4F, 0.4F, 0.8F), 0.2F),
                          e};
        probe.lighting = {{{{light, glm::vec3(1)}, LightFrame::camera}}, glm::vec3(0.2F), local_viewer, false};
        probes.push_back(probe);
    };
    for (const bool local : {true, false})
        for (const float e : {0.0F, 1.0F, 300.0F, 4.0F, 128.0F}) {
            add({0, 0.6F, 0.8F, 0}, e, local, {0, 0, -4}, {0, 0, 1});
            add({0, 0, 1, 0}, e, local, {3, 0, -4}, {0, 0, 1});
            add({3, 0, -4, 1}, e, local, {0, 0, -4}, {0.6F, 0, 0.8F});
            add({0, 0.6F, -0.8F, 0}, e, local, {0, 0, -4}, {0, 0, 1});
            add({1, 0, 0, 0}, e, local, {0, 0, -4}, {0, 0, 3});
        }
    return probes;
}

}
