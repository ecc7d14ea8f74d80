#pragma once

#include <string>
#include <vector>

#include "measurement.hpp"
#include "plot.hpp"

namespace umbral::bench {

/// A plot and the sentences below it.
struct Figure {
    Plot plot;
    std::vector<std::string> captions;
};

/// The plots of a knob, the most telling first and large: error against time, a plot for each curve; or, if there are
/// several situations, one with all of them, and the other measures over their axis.
[[nodiscard]] std::vector<Figure> figures_of(const Knob& knob);

}
