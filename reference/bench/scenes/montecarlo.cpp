// Pictures by random samples, averaged as light and then encoded, once a pixel.

#include "scenes.hpp"
#include "tracing.hpp"

namespace umbral::bench::scenes {
namespace {

Traced world(const Pose& pose, Estimate estimate, int samples)
{
    Traced w;
    w.estimate = estimate;
    w.width = w.height = pose.size * 3 / 4;
    w.samples = samples;
    const float t = 0.15F * pose.time();
    w.balls = {{{-1.25F + t, 0.9F, 0}, 0.9F, {0.85F, 0.35F, 0.25F}},
               {{0.9F, 0.6F, 0.9F - t}, 0.6F, {0.3F, 0.6F, 0.85F}},
               {{0.5F, 1.2F, -1.6F}, 1.2F, {0.85F, 0.8F, 0.4F}}};
    return w;
}

Traced soft_shadow(const Pose& pose)
{
    Traced w = world(pose, Estimate::soft_shadow, 16);
    w.lamp = {0.8F, 4.2F, 1.5F};
    return w;
}

Traced occlusion(const Pose& pose) { return world(pose, Estimate::ambient_occlusion, 16); }

Traced interreflection(const Pose& pose)
{
    Traced w = world(pose, Estimate::interreflection, 16);
    w.balls.push_back({{-0.1F, 0.35F, 1.6F}, 0.35F, {0.9F, 0.9F, 0.9F}});
    return w;
}

Traced lens(const Pose& pose)
{
    Traced w = world(pose, Estimate::depth_of_field, 16);
    w.aperture = 0.22F;
    w.eye = {0, 1.6F, 5};
    w.target = {0.9F, 0.6F, 0.9F};
    w.balls.push_back({{2.2F, 0.8F, -4}, 0.8F, {0.5F, 0.8F, 0.5F}});
    return w;
}

Scene traced_scene(std::string name, std::string about, int size, Traced (*build)(const Pose&), std::vector<Flaw> flaws,
                   std::initializer_list<Way> more)
{
    Scene scene;
    scene.name = std::move(name);
    scene.about = std::move(about);
    scene.noise = true;
    scene.flaws = {Flaw::light_3_percent,
                   Flaw::light_5_percent,
                   Flaw::jitter_correlated,
                   Flaw::half_pixel_centre,
                   Flaw::shifted_one_pixel,
                   Flaw::upside_down,
                   Flaw::red_blue_swapped,
                   Flaw::stale_frame,
                   Flaw::fov_3_percent_wrong,
                   Flaw::camera_1_percent_off,
                   Flaw::blank};
    scene.flaws.insert(scene.flaws.end(), flaws.begin(), flaws.end());
    scene.ways = {Way::fresh_seed_1,   Way::fresh_seed_2,     Way::fresh_seed_3,      Way::fused_multiply_add,
                  Way::other_compiler, Way::double_precision, Way::stratified_samples};
    scene.ways.insert(scene.ways.end(), more);
    scene.draw = [size, build](Painters&, Flaw flaw, Way way) {
        Traced w = build({size, flaw});
        if (flaw == Flaw::camera_1_percent_off) {
            w.eye.x += 0.06F;
            w.target.x += 0.06F;
        }
        // What is wrong is drawn with random numbers of its own, as by anybody who hands it in.
        w.seed = flaw == Flaw::none ? 1 : 100 + static_cast<std::uint64_t>(flaw);
        if (way == Way::fresh_seed_1) w.seed = 2;
        if (way == Way::fresh_seed_2) w.seed = 3;
        if (way == Way::fresh_seed_3) w.seed = 4;
        if (way == Way::stratified_samples || way == Way::uniform_sampling) w.seed = 5;
        if (flaw == Flaw::blank) return Image(w.width, w.height, glm::u8vec4(0, 0, 0, 255));
        return Painters::software(way).trace(w, flaw, way);
    };
    return finish(scene);
}

}

std::vector<Scene> noisy_scenes(int size)
{
    using enum Flaw;
    return {
        traced_scene("soft shadow", "Balls under a square lamp, 16 samples a pixel.", size, soft_shadow,
                     {cosine_missing, shadow_missing, light_as_point}, {}),
        traced_scene("ambient occlusion", "How much of the sky is seen, 16 samples a pixel.", size, occlusion,
                     {shadow_missing, pdf_mismatch, normal_forgotten}, {Way::uniform_sampling}),
        traced_scene("interreflection", "Sky light that bounces between balls, 16 paths a pixel.", size,
                     interreflection, {pdf_mismatch, normal_forgotten, bounce_missing}, {Way::uniform_sampling}),
        traced_scene("depth of field", "Balls through a lens, 16 samples a pixel.", size, lens,
                     {aperture_halved, pixel_not_jittered, cosine_missing, shadow_missing}, {}),
    };
}

}
