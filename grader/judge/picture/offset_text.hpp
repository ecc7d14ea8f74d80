#pragma once

#include <string>

namespace umbral::grader {

/// "3 pixels to the right and 1 pixel up", for a picture that lies so many pixels to the right of another one, and
/// below it; parts of a pixel have two digits, and what is less than a twentieth of a pixel is left out. Empty for no
/// offset.
[[nodiscard]] std::string offset_text(double x, double y);

}
