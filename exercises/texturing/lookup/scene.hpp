#pragma once

#include <kit/color.hpp>
#include <umbral/record/variation.hpp>

#include "../support.hpp"

/// The goal picture of texturing/lookup: a ring on a tiled floor, with nearest texels on the left and blended ones on
/// the right.
namespace umbral::texturing {

/// Distance from a point to the ring, which stands on the floor y = 0, leaning towards the viewer; its axes as columns.
struct Ring {
    float radius = 1.25F;
    float thickness = 0.52F;
    glm::vec3 centre{0, 1.34F, 0};
    glm::mat3 axes{{1, 0, 0}, {0, 0.819F, 0.574F}, {0, -0.574F, 0.819F}};

    [[nodiscard]] glm::vec3 local(const glm::vec3& point) const { return (point - centre) * axes; }

    [[nodiscard]] float distance(const glm::vec3& point) const
    {
        const glm::vec3 q = local(point);
        return length(glm::vec2(length(glm::vec2(q)) - radius, q.z)) - thickness;
    }

    [[nodiscard]] glm::vec3 normal(const glm::vec3& point) const
    {
        const glm::vec3 q = local(point);
        const glm::vec3 core = radius * normalize(glm::vec3(q.x, q.y, 0));
        return axes * normalize(q - core);
    }

    /// Twelve times round, three times about: seams lie inside the picture.
    [[nodiscard]] glm::vec2 coordinates(const glm::vec3& point) const
    {
        constexpr float turn = 6.2831853F;
        const glm::vec3 q = local(point);
        return {12 * std::atan2(q.y, q.x) / turn, 3 * std::atan2(q.z, length(glm::vec2(q)) - radius) / turn};
    }
};

/// Where a ray of unit direction meets the ring, by steps that cannot jump over it; at least 30 if it does not.
inline float meet(const Ring& ring, const glm::vec3& origin, const glm::vec3& direction)
{
    float t = 0;
    for (int i = 0; i < 96 && t < 30; ++i) {
        const float free = ring.distance(origin + t * direction);
        if (free < 1e-4F) return t;
        t += free;
    }
    return 30;
}

/// How much light arrives, from 0 to 1: less the nearer the ray to the light passes the ring.
inline float lit(const Ring& ring, const glm::vec3& point, const glm::vec3& to_light)
{
    float light = 1;
    for (float t = 0.05F; t < 8;) {
        const float free = ring.distance(point + t * to_light);
        light = std::min(light, 0.5F + 0.5F * free / (0.09F * t));
        if (light <= 0) return 0;
        t += std::max(std::abs(free), 0.02F);
    }
    return light * light * (3 - 2 * light);
}

struct Painter {
    Ring ring;
    Grid<glm::vec4> floor = star_tile(24);
    Grid<glm::vec4> skin = braid_tile(16);
    glm::vec3 to_light = normalize(glm::vec3(-0.5F, 1, 0.35F));

    /// The linear colour that a ray of unit direction sees.
    [[nodiscard]] glm::vec3 colour(Recorder& out, const glm::vec3& eye, const glm::vec3& direction, Filter filter) const
    {
        const Sampler sampler{filter, Wrap::repeat, Wrap::repeat};
        const glm::vec3 sky = mix(glm::vec3(0.9F, 0.8F, 0.66F), glm::vec3(0.2F, 0.36F, 0.62F),
                                  glm::smoothstep(-0.05F, 0.45F, direction.y));
        const float to_ring = meet(ring, eye, direction);
        const float to_floor = direction.y < 0 ? -eye.y / direction.y : 1e9F;
        if (to_ring < std::min(30.0F, to_floor)) {
            const glm::vec3 point = eye + to_ring * direction;
            const glm::vec3 normal = ring.normal(point);
            const float diffuse = std::max(0.0F, dot(normal, to_light)) * lit(ring, point + 0.02F * normal, to_light);
            const float shine = std::pow(std::max(0.0F, dot(normal, normalize(to_light - direction))), 60.0F);
            const glm::vec3 base(ask<lookup>(out, skin, sampler, ring.coordinates(point)));
            return base * (0.9F * diffuse + 0.22F + 0.12F * normal.y) + 0.35F * shine * std::min(1.0F, 4 * diffuse);
        }
        if (to_floor > 60) return sky;
        const glm::vec3 point = eye + to_floor * direction;
        const glm::vec3 base(ask<lookup>(out, floor, sampler, 0.55F * glm::vec2(point.x, -point.z)));
        const float contact = glm::smoothstep(-0.1F, 0.9F, ring.distance(point));
        const glm::vec3 seen = base * (0.8F * lit(ring, point, to_light) * to_light.y + 0.3F * contact);
        return mix(seen, sky, 1 - std::exp(-0.0026F * to_floor * to_floor));
    }
};

/// Varied, it is seen from another side.
inline Image picture(Recorder& out, int width, int height, Variation vary = {})
{
    const Painter painter;
    const glm::mat3 turned = vary.turn({0, 1, 0}, 0.5F);
    const glm::vec3 eye = turned * glm::vec3(0, 2.6F, 5.0F);
    const glm::vec3 forward = normalize(glm::vec3(0, 1.16F, 0) - eye);
    const glm::vec3 right = turned * glm::vec3(1, 0, 0);
    const glm::vec3 up = cross(right, forward);
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec2 at =
                (glm::vec2(x, y) + 0.5F - 0.5F * glm::vec2(width, height)) / static_cast<float>(height);
            const glm::vec3 direction = normalize(forward + 0.92F * (at.x * right - at.y * up));
            image.at(x, y) =
                pixel_of(painter.colour(out, eye, direction, 2 * x < width ? Filter::nearest : Filter::bilinear));
        }
    for (int y = 0; y < height; ++y)
        for (int x = width / 2 - 1; x <= width / 2; ++x) image.at(x, y) = glm::u8vec4(255);
    return image;
}

}
