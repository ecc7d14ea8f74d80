#pragma once

#include "../cast.hpp"
#include "soups.hpp"

/// The goal picture: a knot of several thousand triangles above a polished floor, which is the driver's own.
namespace umbral::raytracing {

/// The triangles, and the normals at their corners.
struct KnotScene {
    Soup triangles;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> surroundings;  ///< balls that hold all of them: centre and radius
};

inline KnotScene knot_scene()
{
    KnotScene scene;
    scene.surroundings.emplace_back(0, 1.42F, 0, 1.3F);
    const auto add = [&](const shapes::Shape& shape, auto place, auto turned) {
        for (const std::uint32_t i : shape.indices) {
            if (scene.normals.size() % 3 == 0) scene.triangles.emplace_back();
            Triangle& triangle = scene.triangles.back();
            glm::vec3* const corners[] = {&triangle.v0, &triangle.v1, &triangle.v2};
            *corners[scene.normals.size() % 3] = place(shape.positions[i]);
            scene.normals.push_back(turned(shape.normals[i]));
        }
    };
    // Stood up, and leaning a little.
    const auto stood = [](const glm::vec3& p) {
        return glm::vec3(0.92F * p.x + 0.39F * p.z, p.y, 0.92F * p.z - 0.39F * p.x);
    };
    add(
        shapes::trefoil(120, 12, 0.235F), [&](const glm::vec3& p) { return stood(p) + glm::vec3(0, 1.42F, 0); }, stood);
    const auto as_it_is = [](const glm::vec3& v) { return v; };
    for (int i = 0; i < 9; ++i) {
        const float angle = 0.7F * static_cast<float>(i) + 0.4F;
        const glm::vec3 centre(1.75F * std::cos(angle), 0.16F, 1.75F * std::sin(angle));
        scene.surroundings.emplace_back(centre, 0.161F);
        add(
            shapes::icosphere(2), [&](const glm::vec3& p) { return centre + 0.16F * p; }, as_it_is);
    }
    return scene;
}

inline glm::vec3 studio(const glm::vec3& direction)
{
    const float height = glm::smoothstep(-0.1F, 0.75F, direction.y);
    const glm::vec3 wall = glm::mix(glm::vec3(0.055F, 0.075F, 0.15F), glm::vec3(0.006F, 0.008F, 0.022F), height);
    // A window of light, seen in what shines.
    const float window = glm::smoothstep(0.80F, 0.88F, dot(direction, normalize(glm::vec3(-0.55F, 0.62F, 0.56F))));
    return wall + window * glm::vec3(1.9F, 1.75F, 1.5F);
}

/// The driver's own test, which spares most questions: does the line of a ray of unit direction pass near anything?
inline bool passes_near(const KnotScene& scene, const Ray& ray)
{
    return std::any_of(scene.surroundings.begin(), scene.surroundings.end(), [&](const glm::vec4& ball) {
        const glm::vec3 aside = cross(glm::vec3(ball) - ray.origin, ray.direction);
        return dot(aside, aside) < ball.w * ball.w;
    });
}

/// `first_hit(ray)` is the hierarchy's answer.
template <class FirstHit>
glm::vec3 knot_light(const KnotScene& scene, FirstHit first_hit, const Ray& ray, int mirrors)
{
    const float to_floor = ray.direction.y < 0 ? -ray.origin.y / ray.direction.y : endless;
    const std::optional<FirstTriangle> found = first_hit(ray);
    const bool is_floor = to_floor < endless && !(found && found->hit.t < to_floor);
    if (!is_floor && (!found || found->index >= scene.triangles.size())) return studio(ray.direction);
    glm::vec3 normal(0, 1, 0);
    if (!is_floor) {
        const auto [t, a, b] = found->hit;
        const glm::vec3* const corner = &scene.normals[3 * std::size_t{found->index}];
        normal = normalize((1 - a - b) * corner[0] + a * corner[1] + b * corner[2]);
    }
    const glm::vec3 place = ray.origin + (is_floor ? to_floor : found->hit.t) * ray.direction;

    const glm::vec3 sun = normalize(glm::vec3(-0.55F, 0.95F, 0.6F));
    float key = std::max(0.0F, dot(normal, sun));
    if (key > 0 && first_hit(Ray{place + 2e-3F * normal, sun})) key = 0;
    glm::vec3 color(0.11F, 0.11F, 0.135F);
    if (!is_floor) {
        const bool of_knot = found->index < 2880;
        const float along = static_cast<float>(found->index % 240) / 240;
        const float hue = of_knot ? 0.56F + 0.18F * std::sin(shapes::turn * along) : 0.09F;
        color = glm::vec3(srgb_decoded(glm::dvec3(rainbow(hue, 0.72F, 0.95F))));
    }
    const float sky = 0.5F + 0.5F * normal.y;
    glm::vec3 light = color * (0.80F * key + 0.16F * sky);
    if (is_floor) {
        const float far = glm::smoothstep(3.0F, 16.0F, length(place));
        light = glm::mix(light, glm::vec3(0.055F, 0.075F, 0.15F), far);
        if (far > 0.9F) return light;
    }
    if (mirrors == 0) return light;
    const float share = 0.06F + 0.6F * std::pow(1 - std::abs(dot(normal, ray.direction)), 4.0F);
    const glm::vec3 mirrored = glm::reflect(ray.direction, normal);
    if (!is_floor) return light + (0.10F + share) * studio(mirrored);
    return light + (0.10F + share) * knot_light(scene, first_hit, Ray{place + 2e-3F * normal, mirrored}, mirrors - 1);
}

template <class FirstHit>
Image knot_picture(const KnotScene& scene, FirstHit first_hit)
{
    const Camera camera{{1.1F, 2.0F, 6.0F}, {0, 1.1F, 0}, 0.30F};
    const auto asked = [&](const Ray& ray) {
        return passes_near(scene, ray) ? first_hit(ray) : std::optional<FirstTriangle>();
    };
    return ray_traced(128, 112, camera, [&](const Ray& ray) { return knot_light(scene, asked, ray, 1); });
}

}
