#include "render/budget/draw.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace umbral::render::budget {
namespace {

constexpr std::uint32_t scrambling = 3;  ///< neither the pilot's nor that of the second look

/// The choice among other numbers of rays, by what `drawn` rays took; never fewer than these.
Choice chosen_anew(const Result& result, int drawn, double took, double seconds)
{
    const Setting& setting = result.choice.setting;
    Model model = result.pilot.model;
    const auto keep = [](std::vector<Cut>& cuts, int value) {
        std::erase_if(cuts, [&](const Cut& cut) { return cut.value != value; });
        return cuts.front().cost;
    };
    const double cost = keep(model.depths, setting.depth) * keep(model.bounces, setting.bounces);
    model.ray_seconds = std::max(1e-9, took / drawn / cost);
    Choice choice = most_accurate(model, seconds);
    choice.setting.rays = std::max(choice.setting.rays, drawn);
    choice.predicted = predict(model, choice.setting);
    choice.reached = result.choice.reached;
    choice.compared = result.choice.compared;
    return choice;
}

}

double wall_seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result draw_within(const Wish& wish, const scene::Scene& scene, DrawList list, int width, int height, int threads,
                   std::function<double()> clock)
{
    Result result;
    result.wish = wish;
    result.whole = {1, list.depth, list.bounces};
    const double start = clock();
    const rays::World world = rays::make_world(list);
    const Stage stage{scene, list, world, width, height, threads, std::move(clock)};
    result.prepared_seconds = stage.clock() - start;
    result.pilot = fly(stage, result.whole, wish);
    const int every = result.pilot.every;
    const double before = stage.clock() - start;
    // The second picture, by which the error is measured, is as sparse as the pilot's.
    const double in_all = 1 + 1.0 / every;
    const double left = (wish.value - before) / in_all;
    result.choice = wish.is_error ? cheapest(result.pilot.model, wish.value) : most_accurate(result.pilot.model, left);
    result.planned_rays = result.choice.setting.rays;
    Setting part = result.choice.setting;
    if (!wish.is_error) part.rays = (part.rays + 1) / 2;
    Look picture = look_at(stage, part, 1, scrambling);
    if (!wish.is_error) result.choice = chosen_anew(result, part.rays, picture.seconds, left);
    const Setting& setting = result.choice.setting;
    if (const int drawn = part.rays; drawn < setting.rays) {
        part.rays = setting.rays - drawn;
        picture = joined(stage, std::move(picture), drawn, look_at(stage, part, 1, scrambling, drawn), part.rays);
    }
    result.predicted_seconds = before + in_all * result.choice.predicted.seconds;
    const Look again = look_at(stage, setting, every, scrambling + 1);
    result.measured_error =
        std::hypot(error_between(shown_of(stage, picture.frame, every), again.shown), result.choice.predicted.bias);
    result.render_seconds = picture.seconds;
    result.followed = picture.rays;
    result.frame = std::move(picture.frame);
    result.measured_seconds = stage.clock() - start;
    return result;
}

}
