#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace umbral::bench {
namespace {

using namespace render;
using namespace render::budget;

double processor_seconds()
{
    timespec now{};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double true_error(const std::vector<double>& shown, const std::vector<double>& converged)
{
    const std::vector<double> apart = difference(shown, converged);
    return std::sqrt(mean_product(apart, apart));
}

std::vector<double> shown_of(const Stage& stage, const Setting& setting) { return look_at(stage, setting, 1, 3).shown; }

void search(const Stage& stage, const Plan& plan, const std::vector<double>& converged, Trial& trial)
{
    double least = std::numeric_limits<double>::infinity();
    const Pilot& pilot = trial.by_error.pilot;
    for (const Cut& depth : pilot.model.depths)
        for (const Cut& bounces : pilot.model.bounces)
            for (const int rays : numbers_of_rays()) {
                const Setting setting{rays, depth.value, bounces.value};
                const Look look = look_at(stage, setting, 1, 3);
                if (look.rays >= least || rays > plan.converged_rays / 4) break;
                const double error = true_error(look.shown, converged);
                if (error > plan.error) continue;
                least = look.rays;
                trial.best = setting;
                trial.best_error = error;
            }
    trial.cost_ratio = trial.by_error.followed / least;
}

}

Trial try_scene(const scene::Scene& scene, const Plan& plan)
{
    DrawList list = make_draw_list(scene, plan.width, plan.height, true);
    const rays::World world = rays::make_world(list);
    const Stage stage{scene, list, world, plan.width, plan.height, 1, processor_seconds};
    const Setting whole{plan.converged_rays, list.depth, list.bounces};
    const std::vector<double> converged = look_at(stage, whole, 1, 9).shown;
    list.depth = whole.depth;
    list.bounces = whole.bounces;
    Trial trial;
    const auto ask = [&](const Wish& wish) {
        return draw_within(wish, scene, make_draw_list(scene, plan.width, plan.height, true), plan.width, plan.height,
                           1, processor_seconds);
    };
    trial.by_error = ask({true, plan.error});
    trial.true_error = true_error(shown_of(stage, trial.by_error.choice.setting), converged);
    search(stage, plan, converged, trial);
    if (plan.seconds > 0) {
        trial.by_time = ask({false, plan.seconds});
        trial.true_error_by_time = true_error(shown_of(stage, trial.by_time.choice.setting), converged);
    }
    return trial;
}

}
