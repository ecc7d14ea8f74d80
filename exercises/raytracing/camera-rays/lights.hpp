#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <umbral/raytracing/camera_rays.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../rays.hpp"

/// Light for small pictures, and what came of it.
namespace umbral::raytracing {

/// Light that changes fast within a pixel, so that each sample counts, along `waves`.
struct LightOfWaves {
    std::string name;
    glm::vec3 waves;

    [[nodiscard]] glm::vec3 along(const glm::vec3& d) const
    {
        const float phase = dot(waves, d);
        if (name == "waves") return {4 + 4 * std::sin(phase), 0.5F + 0.5F * d.x, std::exp(2 * d.y)};
        if (name == "bright and dark stripes")  // two of three samples see the same, so that the first ones often agree
            return glm::mix(glm::vec3(0.25F, 0.125F, 0), glm::vec3(1, 2, 1.5F),
                            glm::clamp(0.5F + 2 * std::sin(phase), 0.0F, 1.0F));
        return 4.0F * max(glm::vec3(0), sin(glm::vec3(0, 0.5F, 1) + phase));  // 0 for some or all channels
    }
};

/// The question in words; `kind` is width, height and n.
inline void ask_for_picture(Recorder& out, const glm::ivec3& kind, const std::string& light)
{
    ask_in_words(out, [&] {
        return "render_picture(camera, " + std::to_string(kind.x) + ", " + std::to_string(kind.y) + ", " +
               std::to_string(kind.z) + ", " + light + ")";
    });
}

inline void record_light(Recorder& out, const PrimaryCamera& camera, const glm::ivec3& kind, const LightOfWaves& light)
{
    std::uint32_t asked = 0;
    const LightAlongRay light_along = [&](const Ray& ray) {
        ++asked;
        return light.along(ray.direction + 0.1F * (ray.origin - camera.eye));
    };
    ask_for_picture(out, kind, light.name);
    const Grid<glm::vec3> picture = render_picture(camera, kind.x, kind.y, kind.z, light_along);
    out.columns("size", "width, height");
    out.append("size", glm::vec2(picture.width, picture.height));
    out.append("rays", asked);
    for (int y = 0; y < kind.y; ++y)
        for (int x = 0; x < kind.x; ++x)
            out.append("light", picture.contains(x, y) ? picture.at(x, y) : glm::vec3(not_a_number));
}

/// Channels that differ, none of them by more than a factor of ten.
inline glm::vec3 some_color(Random& random)
{
    const float red = random.uniform(0.1F, 1);
    const float green = random.uniform(0.1F, 1);
    return {red, green, random.uniform(0.1F, 1)};
}

/// Light that is the same everywhere: the mean is this light. Channel by channel, as each is right by itself.
inline void record_even_light(Recorder& out, std::string_view name, const glm::ivec3& kind, const glm::vec3& light)
{
    ask_for_picture(out, kind, "light of " + literal::of_value(light, true, {}) + " everywhere");
    const Grid<glm::vec3> picture = render_picture({}, kind.x, kind.y, kind.z, [&](const Ray&) { return light; });
    for (int y = 0; y < kind.y; ++y)
        for (int x = 0; x < kind.x; ++x)
            for (int channel = 0; channel < 3; ++channel)
                out.append(name, picture.contains(x, y) ? picture.at(x, y)[channel] : not_a_number);
}

}
