#pragma once

#include <kit/channels.hpp>
#include <kit/single_points.hpp>

#include "stage.hpp"

/// Single rays, each drawn as one pixel.
namespace umbral::raytracing {

/// One ray of a scene: through this place of its picture.
template <class Scene>
struct OneRay {
    Scene scene;
    glm::vec2 place{0};
};

/// Of six, one lacks a channel.
inline glm::vec3 random_color(Random& random, float most)
{
    const glm::vec3 color = 0.5F * most * (glm::vec3(1) + random.in_cube());
    return random.below(6) == 0 ? without_a_channel(random, color) : color;
}

template <class Visit>
void for_each_input_of_look(RayLook& look, const Visit& visit)
{
    visit("half_height", look.half_height);
    visit("ambient", look.ambient);
    visit("horizon", look.horizon);
    visit("zenith", look.zenith);
}

/// What the shaders are fed with for a ray, under the names that they know, but for what setting_text() says.
template <class Visit>
void for_each_input(OneRay<BallScene>& ray, const Visit& visit)
{
    BallScene& scene = ray.scene;
    visit("place", ray.place);
    for_each_input_of_look(scene.look, visit);
    visit("light_position", scene.light_position);
    visit("light_color", scene.light_color);
    visit("levels", scene.levels);
    visit("floor_mirror", scene.floor_mirror);
    visit("floor_radius", scene.floor_radius);
    visit("tiles[0]", scene.tiles[0]);
    visit("tiles[1]", scene.tiles[1]);
}

template <class Visit>
void for_each_input(OneRay<SpongeScene>& ray, const Visit& visit)
{
    SpongeScene& scene = ray.scene;
    visit("place", ray.place);
    for_each_input_of_look(scene.look, visit);
    visit("depth", scene.depth);
    visit("ball", scene.ball);
    visit("sponge_color", scene.sponge_color);
    visit("ball_color", scene.ball_color);
    visit("sun", scene.sun);
    visit("sun_color", scene.sun_color);
}

inline const char* file_of(const BallScene&) { return "ray_tracer.frag"; }
inline const char* file_of(const SpongeScene&) { return "distance_field.frag"; }

/// Where the eye is, which also turns the camera, and what there may be many of.
inline std::string setting_text(const BallScene& scene) { return camera_text(scene.look) + balls_text(scene); }
inline std::string setting_text(const SpongeScene& scene) { return camera_text(scene.look); }

/// The colours of single rays, 0 to 1, each drawn as one pixel.
template <class Scene>
std::vector<glm::vec3> colors_of_rays(const gl::Program& program, const std::vector<OneRay<Scene>>& rays)
{
    const auto size = static_cast<int>(rays.size());
    const gl::Framebuffer frame(size, 1);
    frame.clear({1, 0, 1, 1});
    program.set("aspect", 1.0F);
    const WholePicture triangle(program);
    for (int i = 0; i < size; ++i) {
        glViewport(i, 0, 1, 1);
        give(program, rays[static_cast<std::size_t>(i)].scene);
        program.set("shift", rays[static_cast<std::size_t>(i)].place);
        triangle.draw();
    }
    std::vector<glm::vec3> colors;
    for (const glm::u8vec4& pixel : frame.read_pixels().cells) colors.push_back(glm::vec3(pixel) / 255.0F);
    return colors;
}

template <class Scene>
void record_rays(Recorder& out, std::string_view name, const gl::Program& program,
                 const std::vector<OneRay<Scene>>& rays)
{
    record_single_points(
        out, name, file_of(Scene{}), rays, [](const OneRay<Scene>& ray) { return setting_text(ray.scene); },
        [&](const std::vector<OneRay<Scene>>& asked) { return colors_of_rays(program, asked); });
}

}
