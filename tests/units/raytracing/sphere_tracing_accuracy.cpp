// Prints how many points rays look at: the table in the statement of raytracing/sphere-tracing.
// Usage: sphere-tracing-accuracy [SEED [RAYS]]

#include <cstdio>
#include <cstdlib>
#include <raytracing/sphere-tracing/bodies.hpp>

using namespace umbral;
using namespace umbral::raytracing;
using namespace umbral::raytracing::sdf;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 20'000;
    std::printf("seed %llu, %d rays: points on average, and at most\n%12s%10s%10s%10s%10s%10s\n",
                static_cast<unsigned long long>(seed), rays, "tolerance", "meet %", "average", "most", "miss", "most");
    for (const float tolerance : {1e-2F, 1e-3F, 1e-4F, 1e-5F}) {
        Random random(seed);
        int asked = 0;
        const Bodies sponge{[&](const glm::vec3& p) {
            ++asked;
            return menger_distance(p, 4);
        }};
        long long sum[2] = {};
        int number[2] = {};
        int most[2] = {};
        for (int i = 0; i < rays; ++i) {
            Ray ray = aimed_at(1.3F * random.in_cube(), glm::dvec3(random.unit_vector()), 4);
            ray.t_max = 8;
            asked = 0;
            const int met = sphere_trace(ray, sponge, {tolerance, 1000}) ? 0 : 1;
            sum[met] += asked;
            ++number[met];
            most[met] = std::max(most[met], asked);
        }
        std::printf("%12g%10.1f%10.1f%10d%10.1f%10d\n", static_cast<double>(tolerance), 100.0 * number[0] / rays,
                    static_cast<double>(sum[0]) / number[0], most[0], static_cast<double>(sum[1]) / number[1], most[1]);
    }
}
