#include "raytrace/traversals.hpp"

#include <array>

namespace umbral::raytrace {

std::span<const Traversal> traversals()
{
#ifdef __x86_64__
    static const std::array<Traversal, 2> all = {avx2_traversal(), plain_traversal()};
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    return std::span(all).subspan(has_avx2 ? 0 : 1);
#else
    static const std::array<Traversal, 1> all = {plain_traversal()};
    return all;
#endif
}

Hit first_hit(const Hierarchy& hierarchy, const Ray& ray)
{
    static const Traversal& best = traversals().front();
    return best.first_hit(hierarchy, ray);
}

bool is_blocked(const Hierarchy& hierarchy, const Ray& ray)
{
    static const Traversal& best = traversals().front();
    return best.is_blocked(hierarchy, ray);
}

}
