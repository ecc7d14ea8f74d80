// Compiled for AVX2; called only where the processor has it.

#include "raytrace/traversals.hpp"
#include "raytrace/traverse.hpp"

namespace umbral::raytrace {
namespace {

struct Avx2 {};

}

Traversal avx2_traversal() { return traversal_by<Avx2>("AVX2"); }

}
