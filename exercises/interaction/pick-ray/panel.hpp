#pragma once

#include <kit/picture.hpp>
#include <umbral/interaction/pick_ray.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "balls.hpp"

/// The goal picture: an eye, its picture of few pixels, each of the colour that its ray meets, and the ray that picks.
namespace umbral::interaction {

inline projections::ViewFrame frame_looking(const glm::vec3& eye, const glm::vec3& target)
{
    const glm::vec3 z = normalize(eye - target);
    const glm::vec3 x = normalize(cross(glm::vec3(0, 1, 0), z));
    return {x, cross(z, x), z, eye};
}

/// What the eye in the picture sees; what is near it is not seen.
inline PickView view_of_the_eye(Variation& vary, int columns, int rows)
{
    const glm::vec3 eye = vary.near(glm::vec3(0.1F, 1.15F, 5.4F), 0.35F);
    return {frame_looking(eye, {0.05F, 0.55F, -0.6F}), {-0.92F, 0.92F, -0.66F, 0.72F, 2.4F, 30}, {columns, rows}};
}

/// The nearest places of a ray and a segment: how far apart they are, and where on the ray.
struct Passing {
    float distance;
    float t;
};

inline Passing passing(const Ray& ray, const glm::vec3& from, const glm::vec3& to)
{
    const glm::vec3 along = to - from;
    const glm::vec3 aside = ray.origin - from;
    const float b = dot(ray.direction, along);
    const float c = dot(along, along);
    const float d = dot(ray.direction, aside);
    const float e = dot(along, aside);
    const float s = std::clamp((e - b * d) / std::max(c - b * b, 1e-6F), 0.0F, 1.0F);
    const float t = std::max(0.0F, b * s - d);
    return {length(aside + t * ray.direction - s * along), t};
}

class PanelPicture {
public:
    static constexpr int columns = 16;
    static constexpr int rows = 12;
    static constexpr glm::ivec2 clicked{5, 7};

    /// Asks for the ray of each pixel.
    explicit PanelPicture(Variation& vary, Recorder& out)
        : view_(view_of_the_eye(vary, columns, rows)), colors_(columns, rows)
    {
        ray_ = ask<pick_ray>(out, view_, clicked);
        const Met met = first_met(ray_);
        picked_ = met.id;
        end_ = ray_.origin + std::min(met.t, 12.0F) * ray_.direction;
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                colors_.at(column, row) = light_of_balls(ask<pick_ray>(out, view_, glm::ivec2(column, row)), picked_);
    }

    /// Seen from beside the eye.
    [[nodiscard]] Image picture(int width, int height) const
    {
        Grid<glm::vec3> light(2 * width, 2 * height);
        const projections::ViewFrame viewer = frame_looking({5.1F, 2.7F, 6.6F}, {0.1F, 0.72F, 1.75F});
        for (int y = 0; y < light.height; ++y)
            for (int x = 0; x < light.width; ++x) {
                const float right = (static_cast<float>(2 * x + 1) - static_cast<float>(light.width));
                const float up = (static_cast<float>(light.height) - static_cast<float>(2 * y + 1));
                const glm::vec2 at = 0.33F * glm::vec2(right, up) / static_cast<float>(light.height);
                light.at(x, y) =
                    light_along({viewer.origin, normalize(at.x * viewer.x + at.y * viewer.y - viewer.z), 0, 60});
            }
        return halved(encoded(light));
    }

private:
    [[nodiscard]] glm::vec3 corner(float right, float up) const
    {
        const auto& [left, r, bottom, top, near_plane, far_plane] = view_.frustum;
        const auto& [x_axis, y_axis, z_axis, eye] = view_.frame;
        return eye + glm::mix(left, r, right) * x_axis + glm::mix(bottom, top, up) * y_axis - near_plane * z_axis;
    }

    [[nodiscard]] glm::vec3 light_along(const Ray& ray) const
    {
        const float solid = first_met(ray).t;
        glm::vec3 light = light_of_balls(ray, picked_);
        // The panel of pixels: a pane in the near plane.
        const glm::vec3 low = corner(0, 0);
        const glm::vec3 right = corner(1, 0) - low;
        const glm::vec3 up = corner(0, 1) - low;
        const glm::vec3& back = view_.frame.z;
        const float t = dot(low - ray.origin, back) / dot(ray.direction, back);
        const glm::vec3 on = ray.origin + t * ray.direction - low;
        const glm::vec2 at(dot(on, right) / dot(right, right), 1 - dot(on, up) / dot(up, up));
        if (t > 0 && t < solid && at.x > 0 && at.x < 1 && at.y > 0 && at.y < 1)
            light = glm::mix(light, pane(at), 0.86F);
        light += beams(ray, std::min(solid, 60.0F));
        return light;
    }

    [[nodiscard]] glm::vec3 pane(const glm::vec2& at) const
    {
        const glm::vec2 place = at * glm::vec2(columns, rows);
        const glm::ivec2 pixel = glm::min(glm::ivec2(place), glm::ivec2(columns - 1, rows - 1));
        const glm::vec2 from_middle = abs(glm::fract(place) - 0.5F);
        const float to_border = 0.5F - std::max(from_middle.x, from_middle.y);
        glm::vec3 light = colors_.at(pixel.x, pixel.y);
        const bool is_clicked = pixel == clicked;
        const glm::vec3 seam = is_clicked ? glm::vec3(1.0F, 0.62F, 0.18F) : glm::vec3(0.01F, 0.012F, 0.02F);
        const float width = is_clicked ? 0.16F : 0.05F;
        light = glm::mix(seam, light, glm::smoothstep(width - 0.03F, width + 0.03F, to_border));
        // The centre, through which the ray passes.
        const float dot_size = length(from_middle);
        return glm::mix(light, glm::vec3(0.75F), 0.35F * (1 - glm::smoothstep(0.05F, 0.09F, dot_size)));
    }

    /// The eye, the frustum's edges and the ray that picks: light of their own, hidden by solid things.
    [[nodiscard]] glm::vec3 beams(const Ray& ray, float solid) const
    {
        glm::vec3 light(0);
        const auto add = [&](const glm::vec3& from, const glm::vec3& to, float width, const glm::vec3& color) {
            const Passing at = passing(ray, from, to);
            if (at.t > solid + 0.02F) return;
            const float share = at.distance / width;
            light += color * (std::exp(-share * share) + 0.10F * std::exp(-0.12F * share * share));
        };
        const glm::vec3 eye = view_.frame.origin;
        for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
            add(eye, corner(at.x, at.y), 0.008F, glm::vec3(0.10F, 0.16F, 0.28F));
        add(ray_.origin, end_, 0.014F, glm::vec3(2.2F, 0.95F, 0.20F));
        add(end_, end_, 0.05F, glm::vec3(1.8F, 0.9F, 0.35F));
        add(eye, eye, 0.075F, glm::vec3(0.9F, 1.1F, 1.4F));
        return light;
    }

    PickView view_;
    Grid<glm::vec3> colors_;
    Ray ray_;
    glm::vec3 end_{0};
    std::uint32_t picked_ = 0;
};

inline void record_picture(Variation& vary, Recorder& out)
{
    const PickView view = view_of_the_eye(vary, 96, 72);
    Grid<std::uint32_t> ids(view.picture.x, view.picture.y);
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x) ids.at(x, y) = first_met(ask<pick_ray>(out, view, glm::ivec2(x, y))).id;
    out.buffer("ids", ids);
    out.image("picture", PanelPicture(vary, out).picture(440, 240));
}

}
