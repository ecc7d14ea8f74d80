// Prints what a ray costs, by the size of the mesh: the table in the statement of raytracing/bounding-volumes.
// Usage: bounding-volumes-accuracy [SEED [RAYS]]

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <raytracing/bounding-volumes/soups.hpp>

using namespace umbral;
using namespace umbral::raytracing;

namespace {

template <class Ask>
double microseconds(const std::vector<Ray>& rays, Ask ask)
{
    const auto begin = std::chrono::steady_clock::now();
    int hits = 0;
    for (const Ray& ray : rays) hits += ask(ray) ? 1 : 0;
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
    if (hits == 0) std::printf("no hits\n");
    return time.count() / static_cast<double>(rays.size());
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 20'000;
    std::printf("seed %llu: microseconds a ray\n%12s%14s%14s\n", static_cast<unsigned long long>(seed), "triangles",
                "hierarchy", "loop");
    Random random(seed);
    for (const int n : {5, 16, 50, 160}) {
        const Soup soup = hilly_ball(n, random);
        const auto hierarchy = make_triangle_hierarchy(soup);
        std::vector<Ray> list;
        for (int i = 0; i < rays; ++i) list.push_back(ray_into(soup, 4, random));
        const double by_tree =
            microseconds(list, [&](const Ray& ray) { return hierarchy->first_hit(ray).has_value(); });
        list.resize(static_cast<std::size_t>(rays / 200));
        const double by_loop = microseconds(list, [&](const Ray& ray) {
            bool hit = false;
            for (const Triangle& triangle : soup) hit = intersect(ray, triangle).has_value() || hit;
            return hit;
        });
        std::printf("%12zu%14.2f%14.2f\n", soup.size(), by_tree, by_loop);
    }
}
