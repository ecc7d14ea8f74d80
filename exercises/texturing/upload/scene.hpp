#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/shading.hpp>
#include <kit/shapes.hpp>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/upload.hpp>

#include "../support.hpp"

/// The goal picture of texturing/upload: a corner of a museum. Floor, dado, painting, vase and globe have a texture
/// each, at units of their own; three are repeated, and the floor needs its mipmaps.
namespace umbral::texturing {

inline Grid<glm::u8vec3> bytes_of(const Grid<glm::vec4>& linear)
{
    Grid<glm::u8vec3> picture(linear.width, linear.height);
    std::transform(linear.cells.begin(), linear.cells.end(), picture.cells.begin(),
                   [](const glm::vec4& texel) { return glm::u8vec3(pixel_of(glm::dvec3(texel))); });
    return picture;
}

/// A picture from a function of its pixels' centres in the unit square, v up. Linear colours.
template <class Colour>
Grid<glm::u8vec3> drawn(int width, int height, Colour colour)
{
    Grid<glm::u8vec3> picture(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::vec2 at((static_cast<float>(column) + 0.5F) / static_cast<float>(width),
                               1 - (static_cast<float>(row) + 0.5F) / static_cast<float>(height));
            picture.at(column, row) = glm::u8vec3(pixel_of(colour(at)));
        }
    return picture;
}

/// Waves of several lengths, between 0 and 1: the outline of hills, or of land.
inline float waves(glm::vec2 at, float phase)
{
    float sum = 0;
    float weight = 0.5F;
    for (int octave = 0; octave < 5; ++octave) {
        sum += weight * std::sin(at.x + phase) * std::cos(at.y - 1.7F * phase);
        at = glm::vec2(1.6F * at.x - 1.2F * at.y, 1.2F * at.x + 1.6F * at.y);
        phase += 1.9F;
        weight *= 0.52F;
    }
    return 0.5F + 0.5F * sum;
}

/// Hills behind hills under an evening sky. The sun stands on the left: mirrored or upside down it is another picture.
inline Grid<glm::u8vec3> landscape(int width, int height)
{
    return drawn(width, height, [](glm::vec2 at) {
        const glm::vec2 sun(0.28F, 0.62F);
        const float distance = length((at - sun) * glm::vec2(1.5F, 1));
        glm::vec3 color =
            mix(glm::vec3(1.0F, 0.42F, 0.13F), glm::vec3(0.06F, 0.10F, 0.32F), glm::smoothstep(0.4F, 1.05F, at.y));
        color += glm::vec3(1.0F, 0.55F, 0.2F) * (0.5F * std::exp(-6 * distance)) +
                 glm::vec3(1.0F, 0.75F, 0.4F) * (1 - glm::smoothstep(0.070F, 0.078F, distance));
        for (int hill = 0; hill < 4; ++hill) {
            const auto nearer = static_cast<float>(hill);
            const float top =
                0.60F - 0.14F * nearer + 0.2F * (waves({(3.5F + nearer) * at.x, 0.4F}, 2.3F * nearer) - 0.5F);
            const glm::vec3 tone = mix(glm::vec3(0.42F, 0.20F, 0.24F), glm::vec3(0.015F, 0.03F, 0.05F), nearer / 3);
            const float mist = 0.30F * std::exp(-9 * std::max(0.0F, top - at.y));
            color = mix(color, tone * (0.7F + mist), glm::smoothstep(-0.004F, 0.004F, top - at.y));
        }
        return glm::dvec3(color);
    });
}

/// Land and sea by longitude and latitude, with a grid of 30 degrees.
inline Grid<glm::u8vec3> world_map(int width, int height)
{
    return drawn(width, height, [](glm::vec2 at) {
        const float longitude = shapes::turn * at.x;
        const float latitude = 3.1415927F * (at.y - 0.5F);
        const glm::vec3 place(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                              std::cos(latitude) * std::sin(longitude));
        const float rise = waves({2.1F * place.x + 1.3F * place.y, 2.3F * place.z - 0.7F * place.y}, 0.9F);
        const float land = glm::smoothstep(0.545F, 0.56F, rise);
        glm::vec3 color =
            mix(glm::vec3(0.02F, 0.14F, 0.28F), glm::vec3(0.10F, 0.34F, 0.42F), glm::smoothstep(0.4F, 0.55F, rise));
        color =
            mix(color,
                mix(glm::vec3(0.62F, 0.52F, 0.26F), glm::vec3(0.30F, 0.20F, 0.10F), glm::smoothstep(0.56F, 0.8F, rise)),
                land);
        const glm::vec2 cell = glm::abs(glm::fract(at * glm::vec2(12, 6)) - 0.5F);
        if (std::max(cell.x, cell.y) > 0.475F) color = mix(color, glm::vec3(0.85F, 0.70F, 0.40F), 0.55F);
        return glm::dvec3(color);
    });
}

inline constexpr const char* gallery_vertex = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec2 tex_coord;
uniform mat4 camera;
out vec3 place;
out vec3 n;
out vec2 st;
void main()
{
    place = position;
    n = normal;
    st = tex_coord;
    gl_Position = camera * vec4(position, 1.0);
}
)";

inline constexpr const char* gallery_fragment = R"(
in vec3 place;
in vec3 n;
in vec2 st;
uniform sampler2D picture;
uniform vec3 tint;
uniform float gloss;
uniform vec3 eye;
uniform vec3 sun;
uniform vec4 balls[3];
uniform int own_ball;
out vec4 pixel;

void main()
{
    float key = 1.0;
    float open = 1.0;
    for (int ball = 0; ball < 3; ++ball) {
        if (ball == own_ball) continue;
        vec3 to_ball = balls[ball].xyz - place;
        float along = dot(to_ball, sun);
        float beside = length(to_ball - along * sun);
        if (along > 0.0) key *= smoothstep(0.80 * balls[ball].w, 1.15 * balls[ball].w, beside);
        open *= 1.0 - 0.75 * exp(-3.0 * max(0.0, length(to_ball) - 0.8 * balls[ball].w) / balls[ball].w);
    }
    vec3 albedo = tint * srgb_decoded(texture(picture, st).rgb);
    vec3 shade = open * lit(albedo, gloss, normalize(n), normalize(eye - place), sun, key);
    float lamp = exp(-0.14 * dot(place - vec3(-0.2, 1.4, -2.6), place - vec3(-0.2, 1.4, -2.6)));
    pixel = vec4(srgb_encoded(shade * (0.45 + 0.85 * lamp)), 1.0);
}
)";

/// A piece of the room, with texture coordinates.
struct Furnishing {
    shapes::Shape shape;
    std::vector<glm::vec2> tex_coords;
    std::size_t texture = 0;
    glm::vec3 tint{1};
    float gloss = 0;
    int own_ball = -1;  ///< of the three that throw shadows
};

/// A rectangle whose texture coordinates go from 0 to `repeat`.
inline Furnishing panel(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up, glm::vec2 repeat,
                        std::size_t texture, float gloss = 0, const glm::vec3& tint = glm::vec3(1))
{
    Furnishing piece{{}, {{0, 0}, {repeat.x, 0}, repeat, {0, repeat.y}}, texture, tint, gloss, -1};
    piece.shape.quad(corner, along, up);
    return piece;
}

/// A solid of revolution round a vertical axis through `foot`; `profile(v)` is its radius and its height.
template <class Profile>
Furnishing turned(const glm::vec3& foot, Profile profile, glm::vec2 repeat, std::size_t texture, float gloss, int ball)
{
    constexpr int around = 96;
    constexpr int up = 64;
    Furnishing piece{{}, {}, texture, glm::vec3(1), gloss, ball};
    piece.shape = shapes::surface(around, up, [&](float u, float v) {
        const glm::vec2 at = profile(v);
        return foot + glm::vec3(at.x * std::sin(shapes::turn * u), at.y, at.x * std::cos(shapes::turn * u));
    });
    for (int row = 0; row <= up; ++row)
        for (int column = 0; column <= around; ++column)
            piece.tex_coords.push_back(repeat *
                                       glm::vec2(static_cast<float>(column) / around, static_cast<float>(row) / up));
    return piece;
}

/// Texture 0 is the floor's, 1 the dado's, 2 the painting, 3 the globe's, 4 plain.
inline std::vector<Furnishing> room()
{
    std::vector<Furnishing> pieces = {
        panel({-5, 0, 3}, {10, 0, 0}, {0, 0, -6}, {12.5F, 7.5F}, 0, 0.25F),
        panel({-5, 0.12F, -3}, {10, 0, 0}, {0, 0.66F, 0}, {30, 2}, 1, 0.15F),
        panel({-5, 0, -2.98F}, {10, 0, 0}, {0, 0.12F, 0}, {1, 1}, 4, 0, {0.25F, 0.16F, 0.10F}),
        panel({-5, 0.78F, -2.97F}, {10, 0, 0}, {0, 0.05F, 0}, {1, 1}, 4, 0.2F, {0.35F, 0.22F, 0.12F}),
        panel({-5, 0.8F, -3}, {10, 0, 0}, {0, 3, 0}, {1, 1}, 4, 0, {0.42F, 0.16F, 0.12F}),
        panel({-1.06F, 1.09F, -2.95F}, {2.12F, 0, 0}, {0, 1.42F, 0}, {1, 1}, 4, 0.4F, {0.62F, 0.42F, 0.14F}),
        panel({-0.98F, 1.17F, -2.94F}, {1.96F, 0, 0}, {0, 1.26F, 0}, {1, 1}, 4, 0, {0.20F, 0.11F, 0.04F}),
        panel({-0.95F, 1.20F, -2.93F}, {1.90F, 0, 0}, {0, 1.20F, 0}, {1, 1}, 2, 0.05F),
    };
    pieces.push_back(turned(
        {-1.55F, 0, -1.5F},
        [](float v) {
            const float belly = 0.20F + 0.26F * std::sin(3.1415927F * std::pow(v, 0.8F)) * (1 - 0.25F * v);
            return glm::vec2(belly - 0.10F * std::exp(-60 * (v - 0.86F) * (v - 0.86F)), 1.25F * v);
        },
        {12, 5}, 1, 0.55F, 0));
    pieces.push_back(turned(
        {1.5F, 0.70F, -1.35F},
        [](float v) {
            const float angle = 3.1415927F * std::clamp(v, 0.0005F, 0.9995F);
            return 0.46F * glm::vec2(std::sin(angle), -std::cos(angle));
        },
        {1, 1}, 3, 0.45F, 1));
    Furnishing stand = turned(
        {1.5F, 0, -1.35F},
        [](float v) {
            return glm::vec2(0.30F - 0.25F * std::pow(std::max(v, 0.0F), 0.35F) + 0.12F * v * v, 0.30F * v);
        },
        {1, 1}, 4, 0.3F, 2);
    stand.tint = {0.30F, 0.17F, 0.08F};
    pieces.push_back(stand);
    return pieces;
}

/// Varied, it is seen from another place.
inline Image gallery(Recorder& out, int width, int height, Variation vary = {})
{
    constexpr Sampler repeated{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    constexpr Sampler once{Filter::bilinear, Wrap::clamp_to_edge, Wrap::clamp_to_edge};
    constexpr Sampler globe{Filter::bilinear, Wrap::repeat, Wrap::clamp_to_edge};
    const DoubleFrame frame(width, height);
    const gl::Program program({"gallery.vert", gallery_vertex}, lit_fragment_shader("gallery.frag", gallery_fragment));
    const std::array textures = {
        make_texture(bytes_of(star_tile(150)), repeated, true), make_texture(bytes_of(braid_tile(66)), repeated, true),
        make_texture(landscape(285, 179), once, true), make_texture(world_map(361, 181), globe, true),
        make_texture(Grid<glm::u8vec3>(1, 1, glm::u8vec3(255)), once, false)};
    ask_in_words(out, [] { return "// five textures, activated at units 0 to 4; each piece reads its own"; });
    for (std::size_t i = 0; i < textures.size(); ++i)
        if (textures[i]) textures[i]->activate(static_cast<int>(i));
    const glm::vec3 eye(vary.near(0.25F, 0.8F), 1.35F, 3.1F);
    program.set("camera", glm::perspective(glm::radians(40.0F), static_cast<float>(width) / static_cast<float>(height),
                                           0.1F, 30.0F) *
                              glm::lookAt(eye, {0, 1.12F, -2}, {0, 1, 0}));
    program.set("eye", eye);
    program.set("sun", glm::normalize(glm::vec3(-0.9F, 0.85F, 0.5F)));
    const std::array<glm::vec4, 3> balls = {
        glm::vec4(-1.55F, 0.55F, -1.5F, 0.47F), {1.5F, 0.7F, -1.35F, 0.46F}, {1.5F, 0.05F, -1.35F, 0.24F}};
    program.set("balls", std::span<const glm::vec4>(balls));
    glEnable(GL_DEPTH_TEST);
    for (const Furnishing& piece : room()) {
        const AttributeMesh mesh(
            program, piece.shape.indices,
            {{"position", piece.shape.positions}, {"normal", piece.shape.normals}, {"tex_coord", piece.tex_coords}});
        program.set("picture", static_cast<int>(piece.texture));
        program.set("tint", piece.tint);
        program.set("gloss", piece.gloss);
        program.set("own_ball", piece.own_ball);
        mesh.draw();
    }
    return frame.picture();
}

}
