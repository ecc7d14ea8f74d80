#pragma once

#include <kit/picture.hpp>
#include <kit/shapes.hpp>

#include "../cast.hpp"
#include "crowds.hpp"

/// Glass balls before a window of coloured panes, and what they stand on, as fragments: the goal picture.
namespace umbral::raytracing {

struct GlassBall {
    glm::vec3 centre;
    float radius;
    glm::vec3 tint;
};

struct GlassPicture {
    std::vector<OpaqueFragment> opaque;
    std::vector<GlassFragment> panes;  ///< their own light is none
    std::vector<GlassFragment> balls;
};

inline const glm::vec3 glass_sun = glm::normalize(glm::vec3(-0.5F, 0.75F, 0.6F));

/// The sky over a warm horizon, with a soft lamp.
inline glm::vec3 glass_sky(const glm::vec3& d)
{
    const glm::vec3 sky =
        glm::mix(glm::vec3(0.95F, 0.62F, 0.36F), glm::vec3(0.12F, 0.24F, 0.50F), glm::smoothstep(-0.1F, 0.75F, d.y));
    return sky + 30.0F * std::pow(std::max(0.0F, dot(d, glass_sun)), 400.0F) * glm::vec3(1, 0.9F, 0.7F);
}

/// Front and back of a thin ball: more of the sky is mirrored, and less comes through, where it is seen aslant.
inline void add_ball(GlassPicture& picture, const GlassBall& ball, const Ray& ray, const glm::ivec2& pixel)
{
    const glm::vec3 off = ray.origin - ball.centre;
    const float half = dot(off, ray.direction);
    const float left = half * half - dot(off, off) + ball.radius * ball.radius;
    if (left <= 0) return;
    for (const float root : {-1.0F, 1.0F}) {
        const float t = -half + root * std::sqrt(left);
        if (t <= 0) continue;
        const glm::vec3 p = ray.origin + t * ray.direction;
        const glm::vec3 n = (p - ball.centre) / ball.radius;
        const glm::vec3 facing = root < 0 ? n : -n;
        const float cosine = std::min(1.0F, std::max(0.0F, -dot(facing, ray.direction)));
        const float mirrored = 0.04F + 0.96F * std::pow(1 - cosine, 5.0F);
        const glm::vec3 sky = glass_sky(glm::reflect(ray.direction, facing));
        const float path = 0.35F / std::max(0.18F, cosine);
        picture.balls.push_back({pixel, t, mirrored * sky, 1 - mirrored, pow(ball.tint, glm::vec3(path))});
    }
}

/// The floor's tiles and a dark sill behind them.
inline void add_floor(GlassPicture& picture, const Ray& ray, const glm::ivec2& pixel)
{
    if (ray.direction.y >= 0) return;
    const float t = -ray.origin.y / ray.direction.y;
    const glm::vec3 p = ray.origin + t * ray.direction;
    if (p.z < -2.2F) return;
    const bool odd = ((static_cast<int>(std::floor(p.x * 1.25F)) + static_cast<int>(std::floor(p.z * 1.25F))) & 1) != 0;
    const glm::vec3 tile = odd ? glm::vec3(0.62F, 0.57F, 0.50F) : glm::vec3(0.10F, 0.11F, 0.13F);
    const float fade = std::exp(-0.06F * dot(p, p));
    picture.opaque.push_back({pixel, t, tile * (0.25F + 0.75F * fade)});
}

/// A window of lozenges at z = -2.2: coloured panes between bars of lead.
inline void add_window(GlassPicture& picture, const Ray& ray, const glm::ivec2& pixel)
{
    const float t = (-2.2F - ray.origin.z) / ray.direction.z;
    if (t <= 0) return;
    const glm::vec3 p = ray.origin + t * ray.direction;
    if (p.y < 0 || std::abs(p.x) > 3.9F || p.y > 4.2F) return;
    const glm::vec2 q(p.x * 0.9F + p.y * 0.55F, p.x * 0.9F - p.y * 0.55F);
    const glm::vec2 cell = glm::floor(q);
    const glm::vec2 within = glm::abs(q - cell - 0.5F);
    const bool frame = std::abs(p.x) > 3.75F || p.y < 0.12F || p.y > 4.05F;
    if (frame || std::max(within.x, within.y) > 0.465F) {
        picture.opaque.push_back({pixel, t, glm::vec3(0.025F, 0.026F, 0.03F)});
        return;
    }
    constexpr glm::vec3 glass[] = {{0.92F, 0.20F, 0.10F},
                                   {0.95F, 0.70F, 0.15F},
                                   {0.16F, 0.45F, 0.85F},
                                   {0.20F, 0.66F, 0.42F},
                                   {0.85F, 0.80F, 0.72F}};
    const int which = (static_cast<int>(cell.x) * 3 + static_cast<int>(cell.y) * 7 + 700) % 5;
    picture.panes.push_back({pixel, t, glm::vec3(0), 0.85F, glass[which]});
    // A second sheet behind the upper half, so that colours lie over each other.
    if (p.y > 2.1F + 0.5F * std::sin(1.3F * p.x))
        picture.panes.push_back({pixel, t + 0.1F, glm::vec3(0), 0.9F, {0.75F, 0.85F, 1.0F}});
}

inline GlassPicture glass_picture(int width, int height, const Camera& camera)
{
    const std::vector<GlassBall> balls = {
        {{-1.55F, 0.95F, -0.5F}, 0.95F, {0.95F, 0.45F, 0.25F}}, {{0.35F, 0.75F, 0.25F}, 0.75F, {0.35F, 0.75F, 0.95F}},
        {{1.85F, 1.15F, -0.9F}, 1.15F, {0.55F, 0.92F, 0.50F}},  {{-0.62F, 0.45F, 1.25F}, 0.45F, {0.95F, 0.55F, 0.85F}},
        {{1.55F, 0.42F, 1.10F}, 0.42F, {0.98F, 0.85F, 0.35F}},
    };
    GlassPicture picture;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Ray ray = camera_ray(camera, width, height, glm::vec2(x, y) + 0.5F);
            add_floor(picture, ray, {x, y});
            add_window(picture, ray, {x, y});
            for (const GlassBall& ball : balls) add_ball(picture, ball, ray, {x, y});
        }
    return picture;
}

/// The light of the sky, behind everything.
inline GlassFrame behind_the_glass(int width, int height, const Camera& camera)
{
    GlassFrame frame{Grid<glm::vec3>(width, height),
                     Grid<float>(width, height, std::numeric_limits<float>::infinity())};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            frame.light.at(x, y) =
                1.6F * glass_sky(camera_ray(camera, width, height, glm::vec2(x, y) + 0.5F).direction);
    return frame;
}

/// Seen at twice its size and halved. Balls by the second algorithm, panes by the first, as `with_balls` says.
inline Image glass_image(Variation& vary, Recorder& out, int width, int height, bool with_balls)
{
    const Camera camera = varied(vary, {{0.2F, 1.75F, 6.4F}, {0.1F, 1.35F, 0}, 0.36F});
    const GlassPicture picture = glass_picture(2 * width, 2 * height, camera);
    GlassFrame frame = behind_the_glass(2 * width, 2 * height, camera);
    ask<draw_opaque>(out, frame, picture.opaque);
    ask<filter_glass>(out, frame, picture.panes);
    if (with_balls) ask<blend_glass>(out, frame, picture.balls);
    const bool is_whole =
        frame.light.width == 2 * width && frame.light.cells.size() == static_cast<std::size_t>(4 * width * height);
    return is_whole ? halved(encoded(frame.light)) : Image(width, height);
}

}
