#pragma once

#include <cmath>
#include <lighting/fixed-pipeline/probes.hpp>

/// OpenGL's light model as its specification writes it, in double, without OpenGL.
namespace umbral::lighting {

/// The colour of a vertex. All lights that count, up to eight.
inline glm::dvec3 exact_light(const Probe& probe)
{
    const Material& material = probe.material;
    const glm::dvec3 p(probe.position);
    const glm::dvec3 n = normalize(probe.seen_from_behind ? -glm::dvec3(probe.normal) : glm::dvec3(probe.normal));
    const glm::dvec3 v = probe.lighting.local_viewer ? normalize(-p) : glm::dvec3(0, 0, 1);
    const double e = std::min(material.shininess, 128.0F);
    glm::dvec3 sum(material.emission + probe.lighting.global_ambient * material.ambient);
    for (std::size_t i = 0; i < std::min<std::size_t>(probe.lighting.lights.size(), 8); ++i) {
        const auto& [light, frame] = probe.lighting.lights[i];
        const glm::dmat4 to_eye(frame == LightFrame::world ? probe.view : glm::mat4(1));
        const glm::dvec4 q = to_eye * glm::dvec4(light.position);
        const glm::dvec3 l = normalize(glm::dvec3(q) - q.w * p);
        glm::dvec3 reflected(material.ambient);
        if (dot(n, l) > 0) {
            reflected += dot(n, l) * glm::dvec3(material.diffuse);
            reflected += std::pow(std::max(0.0, dot(n, normalize(l + v))), e) * glm::dvec3(material.specular);
        }
        sum += reflected * glm::dvec3(light.color);
    }
    return sum;
}

/// Does a light come in nearly along the surface? There the highlight jumps, and a triangle is lit in part.
inline bool is_grazed(const Probe& probe)
{
    const auto grazes = [&](const PlacedLight& placed) {
        const glm::vec4 q =
            placed.frame == LightFrame::world ? probe.view * placed.light.position : placed.light.position;
        const glm::vec3 l = normalize(glm::vec3(q) - q.w * probe.position);
        return std::abs(dot(normalize(probe.normal), l)) < 0.02F;
    };
    return std::any_of(probe.lighting.lights.begin(), probe.lighting.lights.end(), grazes);
}

/// The same by OpenGL, with what is linked in as the unit.
inline glm::dvec3 light_by_opengl(const LinearFrame& frame, const Probe& probe)
{
    set_lighting(probe.lighting, probe.view);
    set_material(probe.material);
    frame.clear();
    probe.seen_from_behind ? draw_back(probe) : draw_pixel(probe);
    return glm::dvec3(frame.light().at(0, 0));
}

/// The largest difference of a channel.
inline double largest(const glm::dvec3& difference)
{
    return std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
}

}
