#pragma once

#include <kit/picture.hpp>
#include <umbral/record/variation.hpp>

#include "../support.hpp"

/// The goal picture of pipeline/rasterize-triangle: a knot over a polished floor, each pixel drawn by the unit.
namespace umbral::pipeline {

struct ColouredVertex {
    glm::vec3 place;
    glm::vec3 colour;  ///< linear
};

using ColouredTriangle = std::array<ColouredVertex, 3>;

/// A camera in front of which everything lies: nothing has to be clipped.
struct Lens {
    glm::vec3 eye{0, 2.3F, 6.4F};
    glm::vec3 target{0, 1.22F, 0};
    float zoom = 2.75F;  ///< cotangent of half the vertical field of view
    float near_plane = 1;
    float far_plane = 60;
    int width, height;

    [[nodiscard]] WindowVertex project(const glm::vec3& place) const
    {
        const glm::vec3 forward = normalize(target - eye);
        const glm::vec3 right = normalize(cross(forward, glm::vec3(0, 1, 0)));
        const glm::vec3 rel = place - eye;
        const float w = dot(rel, forward);
        const glm::vec2 ndc = zoom * glm::vec2(dot(rel, right), -dot(rel, cross(right, forward))) / w;
        const float half = 0.5F * static_cast<float>(height);
        const float depth = far_plane * (w - near_plane) / (w * (far_plane - near_plane));
        return {half * ndc + 0.5F * glm::vec2(width, height), depth, 1 / w};
    }
};

/// Colours with a depth buffer; `ids` says which triangle is seen, 0 for none.
struct Canvas {
    Grid<glm::vec3> colours;
    Grid<float> depths;
    Grid<std::uint32_t> ids;

    Canvas(int width, int height) : colours(width, height), depths(width, height, 1), ids(width, height) {}
};

/// Draws one triangle through the depth buffer; `shade(weights, pixel)` gives the colour. What lies outside the picture
/// is dropped.
template <class Shade>
void draw(Recorder& out, Canvas& canvas, const Triangle& triangle, std::uint32_t id, Shade shade)
{
    std::vector<Fragment> fragments;
    ask<rasterize_triangle>(out, triangle, canvas.ids.width, canvas.ids.height, fragments);
    for (const auto& [pixel, depth, weights] : fragments) {
        if (!canvas.ids.contains(pixel.x, pixel.y) || !(depth < canvas.depths.at(pixel.x, pixel.y))) continue;
        canvas.depths.at(pixel.x, pixel.y) = depth;
        canvas.colours.at(pixel.x, pixel.y) = shade(weights, pixel);
        canvas.ids.at(pixel.x, pixel.y) = id;
    }
}

template <class T>
T blended(const glm::vec3& weights, const T& a, const T& b, const T& c)
{
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

/// A tube along a trefoil knot, standing on the floor, with colours that go once round the wheel, `hue_shift` further.
inline std::vector<ColouredTriangle> knot(int along, int about, float hue_shift)
{
    constexpr float turn = 6.2831853F;
    const auto core = [](float t) {
        return glm::vec3(std::sin(t) + 2 * std::sin(2 * t), 2.83F + std::cos(t) - 2 * std::cos(2 * t),
                         -1.1F * std::sin(3 * t)) *
                   0.47F +
               glm::vec3(0, 0.32F, 0);
    };
    const glm::vec3 light = normalize(glm::vec3(-0.45F, 0.8F, 0.6F));
    Grid<ColouredVertex> vertices(about, along);
    for (int i = 0; i < along; ++i) {
        const float t = turn * static_cast<float>(i) / static_cast<float>(along);
        const glm::vec3 tangent = normalize(core(t + 0.01F) - core(t - 0.01F));
        const glm::vec3 side = normalize(cross(tangent, glm::vec3(0, 0, 1)));
        for (int j = 0; j < about; ++j) {
            const float angle = turn * static_cast<float>(j) / static_cast<float>(about);
            const glm::vec3 normal = std::cos(angle) * side + std::sin(angle) * cross(side, tangent);
            const glm::vec3 hue = 0.5F + 0.5F * cos(t + hue_shift + glm::vec3(0.3F, 2.5F, 4.4F));
            const float diffuse = std::max(0.0F, dot(normal, light));
            const float shine = std::pow(std::max(0.0F, dot(normal, normalize(light + glm::vec3(0, 0.1F, 1)))), 30.0F);
            vertices.at(j, i) = {core(t) + 0.3F * normal,
                                 (hue * hue + 0.03F) * (0.16F + 0.85F * diffuse + 0.08F * normal.y) + 0.35F * shine};
        }
    }
    std::vector<ColouredTriangle> triangles;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < about; ++j) {
            const int i1 = (i + 1) % along;
            const int j1 = (j + 1) % about;
            triangles.push_back({vertices.at(j, i), vertices.at(j, i1), vertices.at(j1, i1)});
            triangles.push_back({vertices.at(j, i), vertices.at(j1, i1), vertices.at(j1, i)});
        }
    return triangles;
}

/// The knot and its mirror image below a chequered floor of two triangles; all of it goes through the unit.
inline Canvas scene(Recorder& out, Variation& vary, int width, int height)
{
    Lens lens;
    lens.eye.y = vary.near(lens.eye.y, 0.3F);
    lens.zoom = vary.near(vary.one_of(lens.zoom, std::array{2.2F, 2.45F}), 0.1F);
    lens.width = width;
    lens.height = height;
    const auto sky = [&](int y) {
        const float up = 1 - static_cast<float>(y) / static_cast<float>(height);
        return mix(glm::vec3(0.75F, 0.62F, 0.5F), glm::vec3(0.09F, 0.16F, 0.34F), glm::smoothstep(0.55F, 1.05F, up));
    };
    Canvas canvas(width, height);
    Canvas mirror(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) canvas.colours.at(x, y) = sky(y);
    mirror.colours = canvas.colours;

    std::uint32_t id = 2;  // 1 and 2 are the floor's
    for (const ColouredTriangle& triangle : knot(120, 16, vary.one_of(0.0F, std::array{1.6F, 2.8F, 4.6F}))) {
        ++id;
        const auto smooth = [&](glm::vec3 weights, glm::ivec2) {
            return blended(weights, triangle[0].colour, triangle[1].colour, triangle[2].colour);
        };
        Triangle upright{};
        Triangle mirrored{};
        for (std::size_t i = 0; i < 3; ++i) {
            upright[i] = lens.project(triangle[i].place);
            mirrored[i] = lens.project(triangle[i].place * glm::vec3(1, -1, 1));
        }
        draw(out, canvas, upright, id, smooth);
        draw(out, mirror, mirrored, id, smooth);
    }

    const std::array<glm::vec3, 4> corners = {glm::vec3(-40, 0, 5.2F), {40, 0, 5.2F}, {40, 0, -50}, {-40, 0, -50}};
    for (std::uint32_t half = 0; half < 2; ++half) {
        const std::array<glm::vec3, 3> places = {corners[0], corners[1 + half], corners[2 + half]};
        const auto tiles = [&](glm::vec3 weights, glm::ivec2 pixel) {
            const glm::vec3 place = blended(weights, places[0], places[1], places[2]);
            const bool dark = (static_cast<int>(std::floor(place.x)) + static_cast<int>(std::floor(place.z))) % 2 != 0;
            const glm::vec3 stone = dark ? glm::vec3(0.012F, 0.02F, 0.035F) : glm::vec3(0.6F, 0.56F, 0.5F);
            const glm::vec3 polished = mix(stone, mirror.colours.at(pixel.x, pixel.y), dark ? 0.3F : 0.22F);
            const float far = length(place - lens.eye);
            return mix(polished, sky(pixel.y), 1 - std::exp(-0.0016F * far * far));
        };
        draw(out, canvas, {lens.project(places[0]), lens.project(places[1]), lens.project(places[2])}, half + 1, tiles);
    }
    return canvas;
}

}
