// Prints how many pairs each form gets wrong: the table in the statement of raytracing/disc.
// Usage: disc-accuracy [SEED [PAIRS]]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <raytracing/disc/shots.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using Intersect = std::optional<float>(const Ray&, const Disc&);

namespace {

std::optional<float> float_from_the_centre(const Ray& ray, const Disc& disc)
{
    const glm::vec3 to_origin = ray.origin - disc.centre;
    const float t = -dot(to_origin, disc.normal) / dot(ray.direction, disc.normal);
    const glm::vec3 from_centre = to_origin + t * ray.direction;
    if (!(dot(from_centre, from_centre) < disc.radius * disc.radius)) return std::nullopt;
    return t;
}

struct Errors {
    int wrong = 0;     ///< pairs of which one answer is a hit for a miss, or a miss for a hit
    double worst = 0;  ///< error of t where both hit, in ulps
};

Errors errors_of(Intersect* intersect, const std::vector<DiscShot>& shots)
{
    static Intersect* const oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Errors errors;
    for (std::size_t i = 0; i < shots.size(); i += 2) {
        bool wrong = false;
        for (const DiscShot& shot : {shots[i], shots[i + 1]}) {
            const std::optional<float> got = intersect(shot.ray, shot.disc);
            const std::optional<float> exact = oracle(shot.ray, shot.disc);
            wrong = wrong || got.has_value() != exact.has_value();
            if (got && exact) errors.worst = std::max(errors.worst, tests::ulps_between(*got, *exact));
        }
        errors.wrong += wrong ? 1 : 0;
    }
    return errors;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int pairs = count > 2 ? std::atoi(arguments[2]) : 100'000;
    std::printf("seed %llu, %d pairs a column: wrong pairs in %%, worst t in ulp\n",
                static_cast<unsigned long long>(seed), pairs);
    Random random(seed);
    const std::array<std::vector<DiscShot>, 5> columns = {
        random_pairs(random, pairs), remote_pairs(random, 1e4F, pairs), remote_pairs(random, 1e5F, pairs),
        remote_pairs(random, 1e6F, pairs), grazing_pairs(random, pairs)};
    std::printf("%-24s%18s%18s%18s%18s%18s\n", "", "random", "1e4 away", "1e5 away", "1e6 away", "grazing");
    for (const auto& [name, intersect] :
         {std::pair<const char*, Intersect*>{"float, world", tests::solution<Intersect>(IN_FLOAT_MODULE)},
          {"float, from the centre", float_from_the_centre},
          {"reference", tests::solution<Intersect>(REFERENCE_MODULE)}}) {
        std::printf("%-24s", name);
        for (const std::vector<DiscShot>& shots : columns) {
            const Errors errors = errors_of(intersect, shots);
            std::printf("%8.2f %% %6.0f", 100.0 * errors.wrong / pairs, errors.worst);
        }
        std::printf("\n");
    }
}
