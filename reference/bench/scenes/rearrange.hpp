#pragma once

#include "model.hpp"
#include "operators.hpp"

namespace umbral::bench::scenes {

/// The same picture from other data: triangles in another order, from another corner on, or split. Other ways leave the
/// model as it is.
void rearrange(Model& model, Way way);

}
