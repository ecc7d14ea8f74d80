#pragma once

#include <string>

namespace umbral::grader {

/// Which half a scene or a unit belongs to: thresholds are set on one half and reported on the other. Decided by the
/// name alone, so that none moves when others are added. Scenes of a unit ("unit: case/value") go by unit: pictures of
/// one unit are too much alike to be independent.
[[nodiscard]] bool held_out(const std::string& name);

}
