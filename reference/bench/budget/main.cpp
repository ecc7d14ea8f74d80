// bench-budget: pictures asked for by their error and by their time, what was predicted, and what came of it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "scenes.hpp"
#include "trial.hpp"

namespace {

using namespace umbral;
using namespace umbral::bench;
using render::budget::Setting;

constexpr double most_apart = 1.2;  ///< of what is predicted and asked, either way
constexpr double most_cost = 1.3;   ///< over the best setting's

std::string text_of(const Setting& setting)
{
    return fmt::format("{} / {} / {}", setting.rays, setting.depth, setting.bounces);
}

bool is_near(double measured, double predicted)
{
    return measured <= most_apart * predicted && predicted <= most_apart * measured;
}

/// A row of either table; what does not hold is told after the tables.
void add_rows(const scene::Scene& scene, const Plan& plan, std::string& errors, std::string& times, std::string& faults)
{
    const Trial trial = try_scene(scene, plan);
    const auto& chosen = trial.by_error.choice;
    errors += fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {} | {:.2f} | {:.2f} |\n", scene.title,
                          text_of(chosen.setting), 100 * chosen.predicted.error, 100 * trial.by_error.measured_error,
                          100 * trial.true_error, text_of(trial.best), 100 * trial.best_error, trial.cost_ratio);
    const auto demand = [&](bool holds, const char* what) {
        if (!holds) faults += fmt::format("{}: {}\n", scene.title, what);
    };
    demand(chosen.reached, "the error asked for was not reached");
    demand(trial.true_error <= most_apart * plan.error, "the error is more than 20 % above the one asked for");
    demand(is_near(trial.true_error, chosen.predicted.error), "the error is more than 20 % from the one predicted");
    demand(trial.cost_ratio <= most_cost, "the cost is more than 1.3 times the best setting's");
    if (plan.seconds <= 0) return;
    const auto& timed = trial.by_time;
    times += fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", scene.title,
                         text_of(timed.choice.setting), timed.predicted_seconds, timed.measured_seconds,
                         100 * timed.choice.predicted.error, 100 * trial.true_error_by_time);
    demand(is_near(timed.measured_seconds, timed.predicted_seconds),
           "the time is more than 20 % from the one predicted");
    demand(std::abs(timed.measured_seconds - plan.seconds) <= (most_apart - 1) * plan.seconds,
           "the time is more than 20 % from the one asked for");
}

int run(const std::string& folder, const Plan& plan)
{
    std::string errors;
    std::string times;
    std::string faults;
    for (const scene::Scene& scene : budget_scenes(folder)) add_rows(scene, plan, errors, times, faults);
    fmt::print(
        "{} x {} pixels; settings are rays / depth / bounces, errors root mean squares of displayed values, in % of "
        "full "
        "scale; the converged picture has {} rays through each pixel\n\n"
        "Asked: an error of {:.3g} %\n\n"
        "| scene | chosen | predicted | measured again | true error | best by search | its error | cost over best's |\n"
        "|---|---|---|---|---|---|---|---|\n{}",
        plan.width, plan.height, plan.converged_rays, 100 * plan.error, errors);
    if (!times.empty())
        fmt::print(
            "\nAsked: {:.3g} s of processor time, the pilot's included\n\n"
            "| scene | chosen | predicted s | measured s | predicted error | true error "
            "|\n|---|---|---|---|---|---|\n{}",
            plan.seconds, times);
    if (!faults.empty()) fmt::print("\nDoes not hold:\n{}", faults);
    return faults.empty() ? 0 : 1;
}

}

int main(int count, char** words)
{
    CLI::App app(
        "Asks for pictures by their error and by their time on eight scenes, and compares with converged pictures, and "
        "with the best setting found by drawing all. Ends with 1 if errors, times or costs are beyond what is "
        "promised.",
        "umbral bench budget");
    std::string folder;
    Plan plan{96, 72, 1024, 0.02, 1};
    bool quick = false;
    app.add_option("SCENES", folder, "The folder of the engine's scenes")->required();
    app.add_option("--width", plan.width, "Pixels; the height is three quarters")->check(CLI::Range(32, 1024));
    app.add_option("--rays", plan.converged_rays, "Of the converged picture")->check(CLI::Range(64, 65536));
    app.add_option("--error", plan.error, "The error asked for, a share of full scale")->check(CLI::Range(1e-4, 0.5));
    app.add_option("--seconds", plan.seconds, "The time asked for")->check(CLI::Range(0.05, 60.0));
    app.add_flag("--quick", quick, "Small pictures; errors and costs only, which do not depend on the machine's load");
    CLI11_PARSE(app, count, words);
    if (quick) plan = {32, 24, 128, 0.05, 0};
    plan.height = plan.width * 3 / 4;
    try {
        return run(folder, plan);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "umbral bench budget: {}\n", error.what());
        return 2;
    }
}
