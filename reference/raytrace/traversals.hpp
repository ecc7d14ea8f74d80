#pragma once

#include "raytrace/hierarchy.hpp"

namespace umbral::raytrace {

/// The same code compiled for every processor, and for those with AVX2.
[[nodiscard]] Traversal plain_traversal();
[[nodiscard]] Traversal avx2_traversal();

}
