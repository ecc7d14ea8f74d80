#include "raytrace/traversals.hpp"
#include "raytrace/traverse.hpp"

namespace umbral::raytrace {
namespace {

struct Plain {};

}

Traversal plain_traversal() { return traversal_by<Plain>("plain"); }

}
