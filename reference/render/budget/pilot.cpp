#include "render/budget/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/picture.hpp"

namespace umbral::render::budget {
namespace {

constexpr int pilot_pixels = 3200;  ///< the error of noise on edges, on a tenth of them, is known to some percent
constexpr int most_pilot_rays = 32;
constexpr int least_pilot_rays = 8;  ///< by less the slope is not known
constexpr int cut_rays = 4;
constexpr double share_of_time = 0.1;  ///< of the time that is wished for, for noise, and for cuts
constexpr int most_sparse = 16;        ///< how many times fewer pixels there may be where time is short

/// As make_picture displays it.
void append_shown(std::vector<double>& shown, const glm::vec4& color, const glm::vec3& background)
{
    const glm::vec3 drawn = glm::clamp(glm::vec3(color), 0.0F, 1.0F);
    const glm::vec3 light = color.a >= 1 ? drawn : drawn + (1 - color.a) * background;
    for (int i = 0; i < 3; ++i) shown.push_back(encoded(light[i]));
}

bool has_mirrors(const scene::Scene& scene)
{
    return std::ranges::any_of(scene.materials, [](const scene::Material& material) {
        return material.mirror != glm::vec3(0) || material.transmit != glm::vec3(0);
    });
}

/// From 3 rays to 4 the cost grows by a third, more than by any later step: where the choice is between them, the noise
/// of 3 is measured, and not put together of that of 2 and of 1.
void measure_three(const Stage& stage, const Setting& whole, const Wish& wish, Pilot& pilot)
{
    if (!wish.is_error || noise_of(pilot.model, 2) <= wish.value || noise_of(pilot.model, 4) > wish.value) return;
    const Setting setting{3, whole.depth, whole.bounces};
    const Look a = look_at(stage, setting, pilot.every, 1);
    const Look b = look_at(stage, setting, pilot.every, 2);
    pilot.model.uneven.push_back({3, error_between(a.shown, b.shown)});
}

/// Shorter and shorter until the bias is beyond what can be of use.
std::vector<Cut> cuts(const Stage& stage, const Setting& whole, int Setting::*knob, int least, int every,
                      const std::function<bool(double)>& enough)
{
    std::vector<Cut> tried = {{whole.*knob, 0, 1}};
    if (whole.*knob <= least) return tried;
    Setting setting = whole;
    setting.rays = cut_rays;
    const Look a = look_at(stage, setting, every, 1);
    const Look b = look_at(stage, setting, every, 2);
    for (int value = std::min(whole.*knob - 1, 6); value >= least; --value) {
        setting.*knob = value;
        const Look short_a = look_at(stage, setting, every, 1);
        const Look short_b = look_at(stage, setting, every, 2);
        const double square = mean_product(difference(short_a.shown, a.shown), difference(short_b.shown, b.shown));
        tried.push_back({value, std::max(tried.back().bias, std::sqrt(std::max(0.0, square))),
                         (short_a.rays + short_b.rays) / (a.rays + b.rays)});
        if (enough(tried.back().bias)) break;
    }
    return tried;
}

}

std::vector<double> shown_of(const Stage& stage, const Frame& frame, int every)
{
    std::vector<double> shown;
    for (int y = 0; y < stage.height; ++y) {
        const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(stage.height);
        const glm::vec3 background = glm::mix(stage.scene.background_top, stage.scene.background_bottom, down);
        for (int x = 0; x < stage.width; ++x)
            if (rays::is_drawn(every, x, y)) append_shown(shown, frame.color.at(x, y), background);
    }
    return shown;
}

Look look_at(const Stage& stage, const Setting& setting, int every, std::uint32_t scrambling, int first)
{
    const double start = stage.clock();
    stage.list.depth = setting.depth;
    stage.list.bounces = setting.bounces;
    rays::RayCounts counts;
    Look look;
    look.frame = rays::draw_by_rays(stage.world, stage.width, stage.height,
                                    {.rays = setting.rays,
                                     .first = first,
                                     .threads = stage.threads,
                                     .spread = true,
                                     .every = every,
                                     .scrambling = scrambling},
                                    &counts);
    look.shown = shown_of(stage, look.frame, every);
    // Rays to parts of lights are among the shadow rays.
    look.rays =
        static_cast<double>(counts.camera + counts.shadow + counts.mirrored + counts.refracted + counts.bounced);
    look.seconds = stage.clock() - start;
    return look;
}

Look joined(const Stage& stage, Look a, int rays_of_a, const Look& b, int rays_of_b)
{
    const float share = static_cast<float>(rays_of_b) / static_cast<float>(rays_of_a + rays_of_b);
    for (std::size_t i = 0; i < a.frame.color.cells.size(); ++i)
        a.frame.color.cells[i] = glm::mix(a.frame.color.cells[i], b.frame.color.cells[i], share);
    a.shown = shown_of(stage, a.frame, 1);
    a.rays += b.rays;
    a.seconds += b.seconds;
    return a;
}

double mean_product(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / static_cast<double>(a.size());
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> result(a.size());
    std::ranges::transform(a, b, result.begin(), std::minus<>());
    return result;
}

double error_between(const std::vector<double>& a, const std::vector<double>& b)
{
    const std::vector<double> apart = difference(a, b);
    return std::sqrt(mean_product(apart, apart) / 2);
}

Pilot fly(const Stage& stage, const Setting& whole, const Wish& wish)
{
    const double start = stage.clock();
    const auto spent = [&] { return stage.clock() - start; };
    Pilot pilot;
    pilot.every = std::max(1, static_cast<int>(1LL * stage.width * stage.height / pilot_pixels));
    if (!wish.is_error) {
        // All up to least_pilot_rays costs twice as many of these, and as much is left for cuts.
        const Look probe = look_at(stage, {1, whole.depth, whole.bounces}, pilot.every, 1);
        const double cost = 4 * (2 * least_pilot_rays - 1) * probe.seconds / (2 * share_of_time * wish.value);
        pilot.every = static_cast<int>(std::ceil(pilot.every * std::clamp(cost, 1.0, 1.0 * most_sparse)));
    }
    for (int rays = 1; rays <= most_pilot_rays; rays *= 2) {
        const Setting setting{rays, whole.depth, whole.bounces};
        const Look a = look_at(stage, setting, pilot.every, 1);
        const Look b = look_at(stage, setting, pilot.every, 2);
        pilot.model.noise.push_back({rays, error_between(a.shown, b.shown)});
        const double drawn = 2.0 * rays * static_cast<double>(a.shown.size()) / 3;
        pilot.model.ray_seconds = std::max(1e-9, (a.seconds + b.seconds) / drawn * stage.width * stage.height);
        const bool among =
            wish.is_error ? pilot.model.noise.back().error <= wish.value : spent() > share_of_time * wish.value;
        if (rays >= least_pilot_rays && among) break;
    }
    measure_three(stage, whole, wish, pilot);
    const double limit = spent() + share_of_time * wish.value;
    const double least_noise = pilot.model.noise.back().error;
    const auto enough = [&](double bias) {
        return wish.is_error ? bias > 0.7 * wish.value : bias > least_noise || spent() > limit;
    };
    pilot.model.depths =
        cuts(stage, whole, &Setting::depth, has_mirrors(stage.scene) ? 0 : whole.depth, pilot.every, enough);
    pilot.model.bounces = cuts(stage, whole, &Setting::bounces, 1, pilot.every, enough);
    pilot.seconds = spent();
    return pilot;
}

}
