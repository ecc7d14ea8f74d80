#pragma once

#include "model.hpp"
#include "operators.hpp"

namespace umbral::bench::scenes {

/// Flaws that lie in the data of a picture or in OpenGL's state, not in a formula; the others leave the model as it is.
void spoil(Model& model, Flaw flaw);

}
