#pragma once

#include <glm/glm.hpp>

/// The named fields, one function each: see fields.hpp and scene::FieldKind.
namespace umbral::render::fields {

/// Based on: D. White, P. Nylander's set of z^8 + c; the distance is estimated from its potential, as J. C. Hart,
/// D. J. Sandin, L. H. Kauffman. Ray Tracing Deterministic 3-D Fractals. SIGGRAPH 1989.
[[nodiscard]] double mandelbulb(const glm::dvec3& place);

}
