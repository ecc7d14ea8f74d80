#pragma once

#include <string>

#include "measurement.hpp"

namespace umbral::bench {

/// docs/accuracy.md: what is measured, the picture of the page, and a table of all knobs.
[[nodiscard]] std::string markdown_of(const Accuracy& accuracy);

}
