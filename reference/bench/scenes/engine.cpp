// The gallery's scenes, drawn by the engine. Nothing of it is shared with the painters of the other families: what
// judges of pictures have learnt from those is tried here on pictures of another make.

#include <utility>

#include "engine_spoil.hpp"
#include "render/picture.hpp"
#include "render/rays/shutter.hpp"
#include "scene/scene_json.hpp"
#include "scene_texts.hpp"
#include "scenes.hpp"

namespace umbral::bench::scenes {
namespace {

/// How the expected picture is made.
enum class Make { raster, rays, noisy_rays };

constexpr int noisy_rays = 16;

const std::vector<Flaw>& candidates(Make make)
{
    using enum Flaw;
    static const std::vector<Flaw> raster = {
        shifted_one_pixel,  upside_down,        mirrored,        red_blue_swapped,     gamma_missing,
        gamma_twice,        sixteen_levels,     blank,           fov_3_percent_wrong,  camera_1_percent_off,
        near_plane_too_far, far_plane_too_near, stale_frame,     rotation_sign,        transform_order,
        one_light_missing,  ambient_missing,    ambient_twice,   diffuse_missing,      specular_missing,
        shininess_halved,   light_3_percent,    light_5_percent, light_in_wrong_space, flat_for_smooth,
        uv_scale_missing,   v_flipped,          u_mirrored,      clamp_for_repeat,     nearest_for_linear,
        thing_missing,      thing_moved,        thing_recoloured};
    static const std::vector<Flaw> rays = [] {
        std::vector<Flaw> all = raster;
        all.insert(all.end(), {reflection_missing, refraction_missing});
        return all;
    }();
    static const std::vector<Flaw> noisy = {
        shifted_one_pixel,    upside_down,       red_blue_swapped, blank,           fov_3_percent_wrong,
        camera_1_percent_off, one_light_missing, light_3_percent,  light_5_percent, light_as_point,
        aperture_halved,      thing_missing,     thing_moved,      thing_recoloured};
    return make == Make::raster ? raster : make == Make::rays ? rays : noisy;
}

std::vector<Way> ways_of(Make make)
{
    using enum Way;
    if (make == Make::raster)
        return {other_renderer, followed_by_rays, triangles_reordered, lights_reversed, world_moved};
    if (make == Make::rays) return {triangles_reordered, lights_reversed, world_moved};
    return {fresh_seed_1, fresh_seed_2, fresh_seed_3, world_moved};
}

/// Of noise: what is wrong is drawn with random numbers of its own, as by anybody who hands it in.
std::uint32_t scrambling(Flaw flaw, Way way)
{
    if (way == Way::fresh_seed_1) return 2;
    if (way == Way::fresh_seed_2) return 3;
    if (way == Way::fresh_seed_3) return 4;
    if (way == Way::world_moved) return 5;
    return flaw == Flaw::none ? 1 : 100 + static_cast<std::uint32_t>(flaw);
}

Image drawn(Painters& painters, const umbral::scene::Scene& scene, Make make, int size, Flaw flaw, Way way)
{
    const bool rays = make != Make::raster || way == Way::followed_by_rays;
    render::rays::Effort effort;
    effort.local_only = make == Make::raster;
    if (make == Make::noisy_rays) {
        effort.rays = noisy_rays;
        effort.spread = true;
        effort.scrambling = scrambling(flaw, way);
    }
    const char* renderer = rays ? "raytrace" : way == Way::other_renderer ? "gl" : "software";
    const render::DrawList list = render::make_draw_list(scene, size, size, rays);
    const render::EffectSet effects = render::derive_effects(list, scene).set;
    const render::Job job{.list = list, .effects = effects, .width = size, .height = size, .effort = std::move(effort)};
    return render::make_picture(painters.engine(renderer, job), scene);
}

Scene engine_scene(std::string_view name, Make make, int size)
{
    const std::string file = std::string(name) + ".json";
    auto given = umbral::scene::parse_scene(scene_text(name), file);
    // One ray through a pixel looks for a lamp's middle only: no noise.
    if (make == Make::rays)
        for (umbral::scene::Light& light : given.lights) light.radius = light.half_angle_degrees = 0;
    Scene scene;
    scene.name = "engine " + std::string(name);
    scene.about = given.title + ", drawn by the engine.";
    scene.noise = make == Make::noisy_rays;
    for (const Flaw flaw : candidates(make))
        if (can_show(given, flaw)) scene.flaws.push_back(flaw);
    scene.ways = ways_of(make);
    scene.draw = [given, make, size](Painters& painters, Flaw flaw, Way way) {
        umbral::scene::Scene changed = given;
        spoil(changed, flaw);
        rearrange(changed, way);
        return recoded(drawn(painters, changed, make, size, flaw, way), flaw);
    };
    return finish(scene);
}

}

std::vector<Scene> engine_scenes(int size)
{
    std::vector<Scene> all;
    for (const char* name : {"android", "first-light", "pinwheels"})
        all.push_back(engine_scene(name, Make::raster, size));
    for (const char* name : {"glass-and-mirror", "whitted"}) all.push_back(engine_scene(name, Make::rays, size));
    for (const char* name : {"penumbra", "soft-light"}) all.push_back(engine_scene(name, Make::noisy_rays, size / 2));
    return all;
}

}
