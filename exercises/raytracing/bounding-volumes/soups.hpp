#pragma once

#include <kit/shapes.hpp>
#include <kit/varied.hpp>
#include <umbral/raytracing/bounding_volumes.hpp>
#include <utility>

#include "../rays.hpp"

/// Triangles for hierarchies, tame and odd ones, and rays to send into them.
namespace umbral::raytracing {

using Soup = std::vector<Triangle>;

inline Triangle triangle_about(const glm::vec3& place, float size, Random& random)
{
    const glm::vec3 a = size * random.in_cube();
    const glm::vec3 b = size * random.in_cube();
    return {place + a, place + b, place + size * random.in_cube()};
}

inline Soup random_soup(Random& random, int count, float size)
{
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 place = glm::vec3(4, 3, 2) * random.in_cube();
        soup.push_back(triangle_about(place + glm::vec3(1, -2, 3), size, random));
    }
    return soup;
}

/// A power of two from 1e-27 to 1e12, for figures that are multiplied by it without rounding.
inline float any_size(Random& random) { return std::exp2(std::floor(random.uniform(-90, 40))); }

/// The same triangles, so many times as large.
inline Soup sized(Soup soup, float size)
{
    for (Triangle& triangle : soup) triangle = {size * triangle.v0, size * triangle.v1, size * triangle.v2};
    return soup;
}

/// Right triangles in planes across the axes, whose legs are edges of their boxes.
inline Soup legs_on_axes(Random& random, int count)
{
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t axis = random.below(3);
        const glm::vec3 corner = 3.0F * random.in_cube();
        glm::vec3 along(0);
        glm::vec3 up(0);
        along[static_cast<int>(axis)] = random.uniform(0.2F, 1);
        up[static_cast<int>(axis + 1) % 3] = random.uniform(0.2F, 1);
        soup.push_back({corner, corner + along, corner + up});
    }
    return soup;
}

inline Soup triangles_of(const shapes::Shape& shape)
{
    Soup soup;
    for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3)
        soup.push_back({shape.positions[shape.indices[i]], shape.positions[shape.indices[i + 1]],
                        shape.positions[shape.indices[i + 2]]});
    return soup;
}

/// A closed, hilly ball of 8 n² triangles, in random order.
inline Soup hilly_ball(int n, Random& random)
{
    Soup soup = triangles_of(shapes::surface(4 * n, n, [](float u, float v) {
        const float latitude = 3.1415927F * (v - 0.5F);
        const glm::vec3 p(std::cos(latitude) * std::cos(shapes::turn * u),
                          std::cos(latitude) * std::sin(shapes::turn * u), std::sin(latitude));
        return p * (1 + 0.1F * std::sin(9 * p.x) * std::cos(7 * p.y + 2 * p.z));
    }));
    return in_random_order(random, std::move(soup));
}

/// All round one middle, from large to small: halves of space do not part them.
inline Soup shells(int count, Random& random)
{
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const auto size = static_cast<float>(1 + i);
        const glm::vec3 a = size * random.unit_vector();
        const glm::vec3 b(double{size} * perpendicular_to(normalize(glm::dvec3(a)), random));
        soup.push_back({a, b, -a - b});
    }
    return in_random_order(random, std::move(soup));
}

/// Each twice as far from the last corner as the one before: halves of space part one at a time.
inline Soup row_of_powers(int count, Random& random)
{
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const float size = std::exp2(0.5F * static_cast<float>(i) - 20);
        soup.push_back(triangle_about(glm::vec3(2 * size, 0, 0), 0.4F * size, random));
    }
    return in_random_order(random, std::move(soup));
}

/// Needles across the whole soup, a ten-thousandth as wide as long.
inline Soup needles(int count, Random& random)
{
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = 3.0F * random.in_cube();
        const glm::vec3 b = a + 2.0F * random.unit_vector();
        soup.push_back({a, b, b + 2e-4F * random.unit_vector()});
    }
    return soup;
}

/// Flat: all in one plane across an axis.
inline Soup floor_of_tiles(int n)
{
    Soup soup;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y) {
            const glm::vec3 corner(x, y, 0);
            soup.push_back({corner, corner + glm::vec3(1, 0, 0), corner + glm::vec3(0, 1, 0)});
            soup.push_back({corner + glm::vec3(1, 1, 0), corner + glm::vec3(0, 1, 0), corner + glm::vec3(1, 0, 0)});
        }
    return soup;
}

/// Some without area, some twice.
inline Soup with_points_and_twins(Random& random, int count)
{
    Soup soup = random_soup(random, count, 1);
    for (int i = 0; i < count; i += 3) {
        const Triangle triangle = soup[static_cast<std::size_t>(i)];
        soup.push_back({triangle.v0, triangle.v0, triangle.v0});
        soup.push_back({triangle.v0, triangle.v1, triangle.v1});
    }
    return soup;
}

/// From outside towards a point of one of the triangles; one in four anywhere.
inline Ray ray_into(const Soup& soup, float distance, Random& random)
{
    glm::vec3 target = 3.0F * random.in_cube();
    if (!soup.empty() && random.below(4) > 0) {
        const Triangle& triangle = soup[random.below(static_cast<std::uint32_t>(soup.size()))];
        const float a = random.uniform(0.1F, 0.8F);
        target = triangle.v0 + a * (triangle.v1 - triangle.v0) +
                 0.9F * (1 - a) * random.uniform() * (triangle.v2 - triangle.v0);
    }
    return aimed_at(target, glm::dvec3(random.unit_vector()), distance);
}

/// A question to meets_box.
struct BoxShot {
    Ray ray;
    BoundingBox box;
};

/// A pair: through a point of the box, and past it. The plane across the ray that parts box and ray leaves 2 % of the
/// box's size.
inline void add_box_pair(std::vector<BoxShot>& shots, int kind, Random& random)
{
    const glm::vec3 low = 3.0F * random.in_cube();
    const glm::vec3 size(random.uniform(0.2F, 2), random.uniform(0.2F, 2), random.uniform(0.2F, 2));
    const BoundingBox box{low, low + size};
    const glm::vec3 middle = low + 0.5F * size;
    const glm::dvec3 from(random.unit_vector());
    const double distance = random.uniform(4, 8);
    const float part = random.uniform(0.02F, 0.98F);
    BoxShot hit{aimed_at(low + glm::vec3(part, random.uniform(0.02F, 0.98F), random.uniform(0.02F, 0.98F)) * size, from,
                         distance),
                box};
    BoxShot miss = hit;
    // How far the box reaches from its middle across the ray.
    const glm::dvec3 aside = perpendicular_to(from, random);
    const double reach = 0.5 * dot(abs(aside), glm::dvec3(size));
    miss.ray = aimed_at(glm::dvec3(middle) + (1.02 + 0.5 * random.uniform_double()) * reach * aside, from, distance);
    if (kind % 5 == 1) {
        miss = hit;
        miss.ray.direction = -miss.ray.direction;
    } else if (kind % 5 == 2) {
        miss = hit;
        miss.ray.t_max = static_cast<float>(distance - double{length(size)} - 0.1);
    } else if (kind % 5 == 3) {
        miss = hit;
        miss.ray.t_min = static_cast<float>(distance + double{length(size)} + 0.1);
    } else if (kind % 5 == 4) {
        hit.ray = {middle, glm::vec3(-from)};
    }
    const float longer = std::exp2(kind % 3 == 0 ? random.uniform(-110, 110) : random.uniform(-8, 8));
    for (Ray* ray : {&hit.ray, &miss.ray}) {
        ray->direction *= longer;
        ray->t_min /= longer;
        ray->t_max /= longer;
    }
    add_pair(shots, hit, miss, random);
}

}
