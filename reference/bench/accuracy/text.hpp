#pragma once

#include <string>

#include "measurement.hpp"

namespace umbral::bench {

/// The measurements as tables of plain text: the front of each curve, its knee, and the sentence.
[[nodiscard]] std::string text_of(const Accuracy& accuracy);

}
