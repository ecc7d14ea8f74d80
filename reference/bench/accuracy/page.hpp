#pragma once

#include <string>

#include "measurement.hpp"

namespace umbral::bench {

/// One HTML page with plots and tables, complete in itself: no script, no other file, light and dark as the reader's
/// system asks.
[[nodiscard]] std::string page_of(const Accuracy& accuracy);

}
