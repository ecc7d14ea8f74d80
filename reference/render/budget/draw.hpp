#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/budget/pilot.hpp"

namespace umbral::render::budget {

/// A picture within a budget, and what was asked, tried, chosen, predicted and measured.
struct Result {
    Wish wish;
    Setting whole;  ///< what the scene says, with one ray
    Pilot pilot;
    int planned_rays = 0;  ///< of the choice before the picture; what is asked by time is chosen anew half way
    Choice choice;
    double prepared_seconds = 0;   ///< surfaces and hierarchy
    double predicted_seconds = 0;  ///< in all: preparing, pilot, picture, and looking at it again
    double render_seconds = 0;     ///< of the picture alone
    double measured_seconds = 0;   ///< in all
    double measured_error = 0;     ///< noise, from part of a second picture by other samples, and the pilot's bias
    double followed = 0;           ///< rays of all kinds, of the picture
    Frame frame;
};

/// Prepares the scene, flies the pilot, chooses, draws, and looks again. Of a picture that is asked for by its time
/// half the rays are drawn first, and how many more are drawn is chosen by what those took: a pilot's rays are fewer
/// and farther apart, and take longer. `list` must hold what rays need; `clock` as in Stage.
[[nodiscard]] Result draw_within(const Wish& wish, const scene::Scene& scene, DrawList list, int width, int height,
                                 int threads, std::function<double()> clock);

/// Seconds on the wall.
[[nodiscard]] double wall_seconds();

/// What was asked, tried and chosen, and why; what was predicted, and what was measured; in percent and seconds.
[[nodiscard]] std::string text_of(const Result& result);

/// The same; errors as parts of full scale, times in seconds.
[[nodiscard]] nlohmann::json to_json(const Result& result);

}
