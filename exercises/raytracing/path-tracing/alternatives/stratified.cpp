// alternative: all paths side by side, their first directions stratified, by the concentric map of the square to the
// disc; paths end when next to nothing is left of the light
#include <algorithm>
#include <cmath>
#include <umbral/raytracing/path_tracing.hpp>
#include <vector>

namespace umbral::raytracing {
namespace {

constexpr float pi = 3.14159265F;

glm::vec3 over_the_hemisphere(const glm::vec3& normal, glm::vec2 square)
{
    const glm::vec2 centred = 2.0F * square - 1.0F;
    glm::vec2 disc(0);
    if (std::abs(centred.x) > std::abs(centred.y)) {
        const float angle = pi / 4 * centred.y / centred.x;
        disc = centred.x * glm::vec2(std::cos(angle), std::sin(angle));
    } else if (centred.y != 0) {
        const float angle = pi / 2 - pi / 4 * centred.x / centred.y;
        disc = centred.y * glm::vec2(std::cos(angle), std::sin(angle));
    }
    const float height = std::sqrt(std::max(0.0F, 1 - dot(disc, disc)));
    const glm::vec3 side = normalize(std::abs(normal.x) > std::abs(normal.z) ? glm::vec3(-normal.y, normal.x, 0)
                                                                             : glm::vec3(0, -normal.z, normal.y));
    return disc.x * side + disc.y * cross(normal, side) + height * normal;
}

glm::vec2 in_square(Random& random)
{
    const float x = random.uniform();
    return {x, random.uniform()};
}

struct Path {
    Ray ray;
    glm::vec3 share{1};
    bool ends = false;
};

glm::vec3 lamps_at(const DiffuseScene& scene, const DiffusePoint& at, Random& random)
{
    glm::vec3 sum(0);
    for (const AreaLamp& lamp : scene.lamps()) {
        const glm::vec2 where = in_square(random);
        const glm::vec3 place = lamp.corner + where.x * lamp.edge_a + where.y * lamp.edge_b;
        const glm::vec3 to_lamp = place - at.position;
        const float here = dot(at.normal, to_lamp);
        const float there = -dot(cross(lamp.edge_a, lamp.edge_b), to_lamp);
        if (here <= 0 || there <= 0 || scene.blocked(at.position, place)) continue;
        const float square = dot(to_lamp, to_lamp);
        sum += lamp.radiance * here * there / (pi * square * square);
    }
    return sum;
}

}

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    return over_the_hemisphere(normal, in_square(random));
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    return std::fmax(0.0F, normal.x * direction.x + normal.y * direction.y + normal.z * direction.z) / pi;
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    const glm::vec3 normal = cross(lamp.edge_a, lamp.edge_b);
    const float r2 = dot(point - on_lamp, point - on_lamp);
    return r2 * std::sqrt(r2) / std::abs(dot(normal, point - on_lamp));
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    std::vector<Path> paths(static_cast<std::size_t>(samples), Path{ray});
    const int across = static_cast<int>(std::sqrt(static_cast<float>(samples)));
    glm::vec3 light(0);
    for (int reflection = 0; !paths.empty(); ++reflection) {
        for (std::size_t i = 0; i < paths.size(); ++i) {
            Path& path = paths[i];
            const auto hit = scene.first_hit(path.ray);
            path.ends = !hit || reflection == bounces;
            if (!hit) light += path.share * scene.sky(path.ray.direction);
            if (hit && (reflection == 0 || hit->lamp == -1)) light += path.share * hit->emitted;
            if (path.ends) continue;
            path.share *= hit->albedo;
            light += path.share * lamps_at(scene, *hit, random);
            const int n = static_cast<int>(i);
            const glm::vec2 cell(static_cast<float>(n % across), static_cast<float>(n / across));
            glm::vec2 square = in_square(random);
            if (reflection == 0 && n < across * across) square = (cell + square) / static_cast<float>(across);
            path.ray = Ray{hit->position, over_the_hemisphere(hit->normal, square)};
            path.ends = std::max({path.share.x, path.share.y, path.share.z}) < 1e-6F;
        }
        std::erase_if(paths, [](const Path& path) { return path.ends; });
    }
    return light / static_cast<float>(samples);
}

}
