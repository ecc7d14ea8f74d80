#pragma once

#include <kit/picture.hpp>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/bump.hpp>

#include "../support.hpp"

/// The goal picture of texturing/bump: a gilded ball of stars before a wall of plaster, both perfectly smooth but for
/// their normals.
namespace umbral::texturing {

/// Heights of a lattice of ribbons round stars, rounded at their edges: in red, from 0 to 1, periodic.
inline Grid<glm::vec4> plaster_heights(int size)
{
    return painted(size, [](glm::vec2 p) {
        const auto square = [](glm::vec2 q) { return std::max(std::abs(q.x), std::abs(q.y)); };
        const auto star = [&](glm::vec2 q) {
            return std::min(square(q), square(glm::vec2(q.x + q.y, q.y - q.x) * 0.70710678F));
        };
        const auto rounded = [](float distance, float width) {
            return glm::smoothstep(width, 0.35F * width, std::abs(distance));
        };
        const glm::vec2 other = glm::vec2(1) - glm::abs(p);
        const float ribbon = std::max(rounded(star(p) - 0.6F, 0.13F), rounded(star(other) - 0.22F, 0.1F));
        const float heart = 0.8F * glm::smoothstep(0.3F, 0.12F, glm::length(p));
        return glm::vec3(std::max(ribbon, heart));
    });
}

/// What the picture asks for at a point: the normal with its relief.
struct Surface {
    glm::vec3 place, normal;
    Tangents tangents;
    glm::vec2 uv;
    float k;
};

inline constexpr glm::vec3 ball_centre{0.05F, 0.05F, 0.75F};
inline constexpr float ball_radius = 0.86F;

/// The ball, where a ray meets it, or the wall z = -0.6 behind it.
inline Surface surface_at(const glm::vec3& eye, const glm::vec3& direction)
{
    constexpr float pi = 3.14159265F;
    const glm::vec3 to_eye = eye - ball_centre;
    const float half = dot(to_eye, direction);
    const float discriminant = half * half - dot(to_eye, to_eye) + ball_radius * ball_radius;
    if (discriminant > 0) {
        const glm::vec3 place = eye + (-half - std::sqrt(discriminant)) * direction;
        const glm::vec3 n = (place - ball_centre) / ball_radius;
        const glm::vec3 q(n.x, 0.940F * n.y + 0.342F * n.z, 0.940F * n.z - 0.342F * n.y);  // its axis leans forward
        const float longitude = std::atan2(q.x, q.z);
        const float latitude = std::asin(std::clamp(q.y, -1.0F, 1.0F));
        const auto turned_back = [](const glm::vec3& t) {
            return glm::vec3(t.x, 0.940F * t.y - 0.342F * t.z, 0.940F * t.z + 0.342F * t.y);
        };
        // Eight tiles round and four from pole to pole.
        const glm::vec3 along(std::cos(longitude) * std::cos(latitude), 0, -std::sin(longitude) * std::cos(latitude));
        const glm::vec3 up(-std::sin(longitude) * std::sin(latitude), std::cos(latitude),
                           -std::cos(longitude) * std::sin(latitude));
        return {place,
                n,
                {ball_radius * 2 * pi / 8 * turned_back(along), ball_radius * pi / 4 * turned_back(up)},
                {8 * longitude / (2 * pi), 4 * latitude / pi},
                0.075F};
    }
    const glm::vec3 place = eye + (-0.6F - eye.z) / direction.z * direction;
    return {place, {0, 0, 1}, {{1.1F, 0, 0}, {0, 1.1F, 0}}, glm::vec2(place) / 1.1F, 0.06F};
}

inline glm::vec3 bump_color(const Grid<glm::vec4>& heights, const glm::vec3& to_light, const glm::vec3& eye,
                            const glm::vec3& direction)
{
    const Surface at = surface_at(eye, direction);
    const glm::vec2 relief = slopes(heights, at.uv, at.k);
    const glm::vec3 n = bumped_normal(at.normal, at.tangents, relief);
    const bool ball = at.normal.z != 1;
    // The ball's shadow on the wall, soft at its edge.
    float light = 1;
    if (!ball) {
        const glm::vec3 to_ball = ball_centre - at.place;
        const float along = dot(to_ball, to_light);
        const float beside = length(to_ball - along * to_light) - ball_radius;
        if (along > 0) light = glm::smoothstep(-0.09F, 0.09F, beside / (0.3F + along));
    }
    const float diffuse =
        light * std::max(0.0F, dot(n, to_light)) * std::max(0.0F, std::min(1.0F, 6 * dot(at.normal, to_light)));
    const glm::vec3 half = normalize(to_light - direction);
    const float height = lookup(heights, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, at.uv).r;
    const glm::vec3 sky(0.26F, 0.31F, 0.42F);
    if (!ball) {
        const glm::vec3 plaster =
            mix(glm::vec3(0.05F, 0.13F, 0.22F), glm::vec3(0.74F, 0.66F, 0.54F), glm::smoothstep(0.1F, 0.5F, height));
        const float near = length(glm::vec2(at.place) - glm::vec2(ball_centre)) - ball_radius;
        return plaster * (1.05F * diffuse * glm::vec3(1, 0.92F, 0.8F) +
                          (0.45F + 0.35F * glm::smoothstep(-0.4F, 0.7F, near)) * sky * (0.75F + 0.25F * n.y));
    }
    const glm::vec3 metal =
        mix(glm::vec3(0.30F, 0.025F, 0.02F), glm::vec3(0.92F, 0.57F, 0.16F), glm::smoothstep(0.1F, 0.5F, height));
    const float gloss = std::pow(std::max(0.0F, dot(n, half)), 38.0F);
    const float rim = std::pow(1 - std::max(0.0F, dot(n, -direction)), 3.0F);
    return metal * (0.85F * diffuse * glm::vec3(1, 0.92F, 0.8F) + sky * (0.62F + 0.38F * n.y)) +
           (0.75F * gloss * std::min(1.0F, 4 * diffuse)) * mix(metal, glm::vec3(1, 0.95F, 0.85F), 0.5F) +
           0.3F * rim * metal * sky;
}

/// One question, told in words: to note the heights for each of its pixels would take seconds. Varied, eye and light
/// are elsewhere.
inline Image picture(Recorder& out, int width, int height, Variation vary = {})
{
    ask_in_words(out, [&] {
        return "// a ball and a wall, " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels: slopes and bumped_normal for each of them, four times";
    });
    const Grid<glm::vec4> heights = plaster_heights(64);
    const glm::vec3 eye = glm::vec3(0.3F, 0.35F, 5.4F) + glm::vec3(vary.near(glm::vec2(0), 0.8F), 0);
    const glm::vec3 to_light = vary.turn({0, 0, 1}, 0.7F) * normalize(glm::vec3(-0.85F, 0.75F, 0.62F));
    const glm::vec3 forward = normalize(glm::vec3(0.02F, 0, 0.2F) - eye);
    const glm::vec3 right = normalize(cross(forward, glm::vec3(0, 1, 0)));
    const glm::vec3 up = cross(right, forward);
    Image image(2 * width, 2 * height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F - glm::vec2(width, height)) / static_cast<float>(2 * height);
            image.at(x, y) =
                pixel_of(bump_color(heights, to_light, eye, normalize(forward + 0.52F * (at.x * right - at.y * up))));
        }
    return halved(image);
}

}
