#include "render/budget/draw.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace umbral::render::budget {

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
    result.choice = wish.is_error ? cheapest(result.pilot.model, wish.value)
                                  : most_accurate(result.pilot.model, (wish.value - before) / in_all);
    result.predicted_seconds = before + in_all * result.choice.predicted.seconds;
    const Setting& setting = result.choice.setting;
    Look picture = look_at(stage, setting, 1, 3);
    const Look again = look_at(stage, setting, every, 4);
    std::vector<double> part;
    for (int y = 0, i = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, i += 3)
            if (rays::is_drawn(every, x, y))
                for (int c = 0; c < 3; ++c) part.push_back(picture.shown[static_cast<std::size_t>(i) + c]);
    result.measured_error = std::hypot(error_between(part, again.shown), result.choice.predicted.bias);
    result.render_seconds = picture.seconds;
    result.followed = picture.rays;
    result.frame = std::move(picture.frame);
    result.measured_seconds = stage.clock() - start;
    return result;
}

}
