#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/ray.hpp>
#include <vector>

/// Scenes of parallelograms and balls, for units that are given a scene and ask it where rays go.
namespace umbral::raytracing {

/// The points corner + a * edge_a + b * edge_b with a, b in [0, 1].
struct SolidQuad {
    glm::vec3 corner;
    glm::vec3 edge_a;
    glm::vec3 edge_b;
};

/// A ball that moves: at a time its centre is centre + time * velocity.
struct SolidBall {
    glm::vec3 centre;
    float radius;
    glm::vec3 velocity{0};
};

/// What a ray meets first: the place of the solid among all that were added, and the point just off its surface on the
/// side of the ray, with the unit normal to that side.
struct SolidHit {
    std::size_t index;
    glm::vec3 position;
    glm::vec3 normal;
    bool front;  ///< on the side of cross(edge_a, edge_b), or outside of a ball
};

/// All that stands in a scene. Rays that begin within 1e-4 of a surface do not meet it there.
class Solids {
public:
    void add(const SolidQuad& quad)
    {
        const glm::vec3 normal = cross(quad.edge_a, quad.edge_b);
        const float square = dot(normal, normal);
        quads_.push_back({quad.corner, normal, cross(quad.edge_b, normal) / square, cross(normal, quad.edge_a) / square,
                          normalize(normal), count_++});
    }
    void add(const SolidBall& ball) { balls_.push_back({ball, count_++}); }

    [[nodiscard]] std::optional<SolidHit> nearest(const Ray& ray, float time = 0) const
    {
        const float length = glm::length(ray.direction);
        const glm::vec3 direction = ray.direction / length;
        float distance = ray.t_max * length;
        const float from = std::max(ray.t_min * length, least);
        const Quad* quad = nullptr;
        const Ball* ball = nullptr;
        for (const Quad& one : quads_)
            if (meets(one, ray.origin, direction, from, distance)) quad = &one;
        for (const Ball& one : balls_)
            if (meets(one.ball, time, ray.origin, direction, from, distance)) ball = &one;
        if (quad == nullptr && ball == nullptr) return std::nullopt;
        const glm::vec3 point = ray.origin + distance * direction;
        const glm::vec3 outwards =
            ball != nullptr ? normalize(point - ball->ball.centre - time * ball->ball.velocity) : quad->unit_normal;
        const bool front = dot(outwards, direction) < 0;
        const glm::vec3 normal = front ? outwards : -outwards;
        return SolidHit{ball != nullptr ? ball->index : quad->index, point + least * normal, normal, front};
    }

    /// Does anything stand between two points, farther than 1e-3 from `to`?
    [[nodiscard]] bool between(const glm::vec3& from, const glm::vec3& to, float time = 0) const
    {
        const float length = glm::length(to - from);
        const glm::vec3 direction = (to - from) / length;
        float distance = length - 1e-3F;
        for (const Quad& one : quads_)
            if (meets(one, from, direction, least, distance)) return true;
        for (const Ball& one : balls_)
            if (meets(one.ball, time, from, direction, least, distance)) return true;
        return false;
    }

private:
    /// A parallelogram, with what turns a point into a and b.
    struct Quad {
        glm::vec3 corner;
        glm::vec3 normal;
        glm::vec3 to_a;
        glm::vec3 to_b;
        glm::vec3 unit_normal;
        std::size_t index;
    };
    struct Ball {
        SolidBall ball;
        std::size_t index;
    };

    static constexpr float least = 1e-4F;

    // Shortens `distance` to where the surface is met, if it lies between `from` and `distance`.
    static bool meets(const Quad& quad, const glm::vec3& origin, const glm::vec3& direction, float from,
                      float& distance)
    {
        const float t = dot(quad.corner - origin, quad.normal) / dot(direction, quad.normal);
        if (!(t > from && t < distance)) return false;
        const glm::vec3 place = origin + t * direction - quad.corner;
        const float a = dot(place, quad.to_a);
        const float b = dot(place, quad.to_b);
        if (a < 0 || a > 1 || b < 0 || b > 1) return false;
        distance = t;
        return true;
    }

    static bool meets(const SolidBall& ball, float time, const glm::vec3& origin, const glm::vec3& direction,
                      float from, float& distance)
    {
        const glm::vec3 to_centre = ball.centre + time * ball.velocity - origin;
        const float middle = dot(to_centre, direction);
        const glm::vec3 aside = to_centre - middle * direction;
        const float half_squared = ball.radius * ball.radius - dot(aside, aside);
        if (half_squared < 0) return false;
        const float half = std::sqrt(half_squared);
        const float t = middle - half > from ? middle - half : middle + half;
        if (!(t > from && t < distance)) return false;
        distance = t;
        return true;
    }

    std::vector<Quad> quads_;
    std::vector<Ball> balls_;
    std::size_t count_ = 0;
};

}
