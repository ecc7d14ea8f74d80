#pragma once

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/picture.hpp>
#include <optional>
#include <umbral/core/random.hpp>
#include <umbral/lighting/light_direction.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// The goal picture: a moon between twelve pictures of itself, taken by a camera that goes round it. The sun of those
/// is fixed in the world, so that the moon waxes and wanes; the lamp of the one in the middle is fixed to the camera,
/// where some keys have put it.
namespace umbral::lighting {

struct Crater {
    glm::vec3 place;  // unit
    float radius;
};

inline std::vector<Crater> craters()
{
    Random random(1969);
    std::vector<Crater> all;
    for (int i = 0; i < 260; ++i) {
        const glm::vec3 place = random.unit_vector();
        const float small = random.uniform();
        all.push_back({place, 0.035F + 0.20F * small * small * small * small});
    }
    return all;
}

/// The moon's normal and its albedo, at a unit vector from its centre.
struct Ground {
    glm::vec3 normal;
    float albedo;
};

inline Ground ground(const std::vector<Crater>& craters, const glm::vec3& n)
{
    // Seas: darker where slow waves are high.
    const float wave = std::sin(2.1F * n.x + 1.3F) * std::sin(2.7F * n.y + 0.4F * n.x) +
                       0.6F * std::sin(3.9F * n.z - 2.2F * n.y) +
                       0.25F * std::sin(9 * n.x + 7 * n.y) * std::sin(8 * n.z);
    Ground result{n, glm::mix(0.60F, 0.26F, glm::smoothstep(-0.05F, 0.45F, wave))};
    for (const Crater& crater : craters) {
        const float cosine = dot(n, crater.place);
        if (cosine < 1 - 0.9F * crater.radius * crater.radius) continue;
        const glm::vec3 aside = n - cosine * crater.place;
        const float distance = length(aside);
        const float x = distance / crater.radius;
        // A bowl that rises towards the rim, and falls outside of it.
        const float slope = x < 1 ? 0.85F * x * x * x : -0.85F * glm::max(0.0F, 1 - (x - 1) / 0.34F);
        if (distance > 0) result.normal -= slope * glm::smoothstep(1.34F, 1.2F, x) * aside / distance;
        result.albedo += x < 1 ? -0.025F : 0.05F * glm::max(0.0F, 1 - (x - 1) / 0.34F);
    }
    result.normal = normalize(result.normal);
    return result;
}

/// Paints a moon that a camera sees: centre and radius in pixels, the light's direction in camera coordinates.
inline void paint_moon(Grid<glm::vec3>& picture, const std::vector<Crater>& craters, const glm::vec2& centre,
                       float radius, const glm::mat3& view, const glm::vec3& to_light, const glm::vec3& color)
{
    const glm::ivec2 low(centre - radius);
    const glm::ivec2 high(centre + radius + 1.0F);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F - centre) / radius;
            const float square = dot(at, at);
            if (square >= 1) continue;
            const glm::vec3 n(at.x, -at.y, std::sqrt(1 - square));
            const Ground here = ground(craters, glm::transpose(view) * n);
            // The ground's own roundness says whether the sun has risen; light of the sky of stars is next to nothing.
            const float risen = glm::smoothstep(-0.05F, 0.12F, dot(n, to_light));
            const float lit = risen * glm::max(0.0F, dot(view * here.normal, to_light));
            picture.at(x, y) = here.albedo * (1.5F * lit * color + glm::vec3(0.004F, 0.005F, 0.008F));
        }
}

/// Varied, the sun stands elsewhere, and so does the camera before the moon in the middle.
inline Image moons(int width, int height, Variation vary = {})
{
    Grid<glm::vec3> picture(2 * width, 2 * height, glm::vec3(0.0015F, 0.002F, 0.005F));
    Random random(12);
    for (int i = 0; i < 420; ++i) {
        const std::uint32_t x = random.below(static_cast<std::uint32_t>(picture.width));
        const std::uint32_t y = random.below(static_cast<std::uint32_t>(picture.height));
        const float bright = random.uniform();
        picture.at(static_cast<int>(x), static_cast<int>(y)) =
            1.8F * bright * bright * bright * glm::mix(glm::vec3(1, 0.8F, 0.6F), glm::vec3(0.6F, 0.8F, 1), bright);
    }
    const std::vector<Crater> all = craters();
    const glm::vec2 middle(width, height);

    const LightAngles sun{vary.near(0.0F, 90.0F), vary.near(8.0F, 20.0F)};
    for (int i = 0; i < 12; ++i) {
        const float turned = glm::radians(30.0F * static_cast<float>(i));
        const glm::mat4 view =
            glm::translate(glm::mat4(1), glm::vec3(0, 0, -4)) * glm::rotate(glm::mat4(1), -turned, glm::vec3(0, 1, 0));
        const glm::vec2 place = middle + glm::vec2(326 * std::sin(turned), 194 * std::cos(turned));
        paint_moon(picture, all, place, 50, glm::mat3(view), direction_in_camera(sun, LightFrame::world, view),
                   {1, 0.95F, 0.86F});
    }

    const std::unique_ptr<LightControl> control = make_light_control({0, 0}, 15);
    if (!control) return halved(encoded(picture));
    for (const char key : {'c', 'c', 'C', 'c', 'A', 'a'}) (void)control->press(key);
    const glm::mat4 view = glm::rotate(glm::mat4(1), vary.near(0.6F, 1.0F), glm::vec3(0.2F, 1, 0));
    paint_moon(picture, all, middle, 122, glm::mat3(view),
               direction_in_camera(control->angles(), LightFrame::camera, view), {1, 0.88F, 0.70F});
    return halved(encoded(picture));
}

}
