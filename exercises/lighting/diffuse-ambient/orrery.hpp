#pragma once

#include <array>
#include <umbral/lighting/diffuse.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

#include "../visible.hpp"

/// The goal picture: planets on their orbits in the light of a sun among them, and in the faint light of the sky from
/// one side.
namespace umbral::lighting {

struct Planet {
    float orbit;   ///< radius
    float angle;   ///< on it, in radians
    float radius;  ///< of the planet
    glm::vec3 color;
};

inline constexpr std::array<Planet, 6> planets = {{{0.95F, 2.45F, 0.15F, {0.75F, 0.62F, 0.50F}},
                                                   {1.35F, 5.55F, 0.24F, {0.86F, 0.66F, 0.34F}},
                                                   {1.85F, 0.45F, 0.29F, {0.18F, 0.42F, 0.78F}},
                                                   {2.35F, 3.75F, 0.23F, {0.80F, 0.26F, 0.13F}},
                                                   {3.05F, 1.95F, 0.62F, {0.82F, 0.60F, 0.42F}},
                                                   {3.75F, 5.35F, 0.42F, {0.83F, 0.74F, 0.52F}}}};

inline Material chalk(const glm::vec3& color) { return {glm::vec3(0), 0.02F * color, color}; }

/// Varied, the planets have moved on.
inline Image orrery(int width, int height, Variation vary = {})
{
    View view = empty_view(width, height);
    constexpr glm::vec3 eye(0, 4.2F, 9.3F);
    const glm::mat4 camera =
        glm::perspective(glm::radians(33.0F), static_cast<float>(width) / static_cast<float>(height), 0.1F, 50.0F) *
        glm::lookAt(eye, glm::vec3(0.15F, -0.2F, 0.3F), glm::vec3(0, 1, 0));
    const auto placed = [](const glm::vec3& place, const glm::vec3& scale) {
        return glm::scale(glm::translate(glm::mat4(1), place), scale);
    };
    std::vector<Material> materials = {{}, {{1.2F, 0.72F, 0.22F}, glm::vec3(0.1F), {0.9F, 0.7F, 0.3F}}};
    const Shape ball = sphere(72, 36);
    draw(view, camera, ball, placed({0, 0, 0}, glm::vec3(0.55F)), 1);
    const glm::mat4 lying = glm::rotate(glm::mat4(1), glm::radians(90.0F), glm::vec3(1, 0, 0));
    for (const Planet& planet : planets) {
        materials.push_back(chalk({0.50F, 0.42F, 0.30F}));
        draw(view, camera, torus(160, 10, 0.017F / planet.orbit), lying * placed({0, 0, 0}, glm::vec3(planet.orbit)),
             static_cast<int>(materials.size()) - 1);
        materials.push_back(chalk(planet.color));
        const float angle = vary.near(planet.angle, 1.5F);
        const glm::vec3 place = planet.orbit * glm::vec3(std::cos(angle), 0, -std::sin(angle));
        draw(view, camera, ball, placed(place, glm::vec3(planet.radius)), static_cast<int>(materials.size()) - 1);
        if (&planet != &planets.back()) continue;
        materials.push_back(chalk({0.70F, 0.56F, 0.36F}));
        const glm::mat4 ring = glm::rotate(glm::translate(glm::mat4(1), place), 0.45F, glm::vec3(0.6F, 0, 1)) * lying *
                               glm::scale(glm::mat4(1), glm::vec3(0.78F, 0.78F, 0.10F));
        draw(view, camera, torus(120, 24, 0.17F), ring, static_cast<int>(materials.size()) - 1);
    }
    const std::vector<Light> lights = {{{0, 0, 0, 1}, {1.15F, 0.95F, 0.70F}},
                                       {{-0.5F, 1.0F, 0.75F, 0}, {0.05F, 0.10F, 0.26F}}};
    return lit_picture(view, {0.004F, 0.005F, 0.012F}, [&](const Visible& seen) {
        Material material = materials[static_cast<std::size_t>(seen.thing)];
        // The limb of a sun is darker than its middle.
        material.emission *= 0.35F + 0.65F * glm::max(0.0F, dot(seen.at.normal, normalize(eye - seen.at.position)));
        return matt_reflection(seen.at, material, lights, glm::vec3(0.02F));
    });
}

}
