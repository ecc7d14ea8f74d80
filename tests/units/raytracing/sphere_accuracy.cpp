// Prints how far the reference and the school formula lie from the oracle: the table in the statement of
// raytracing/sphere. Usage: sphere-accuracy [SEED [RAYS]]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <raytracing/support.hpp>
#include <string>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using Intersect = std::optional<float>(const Ray&, const Sphere&);

namespace {

struct Errors {
    int wrong = 0;         ///< hit for miss, or miss for hit
    double band = 0;       ///< the farthest from the silhouette that one of them passes, in ulps of the distance
    double worst = 0;      ///< error of t where both hit, in ulps, rays with a cosine under 0.1 left out
    double worst_all = 0;  ///< the same with all rays
};

void add(Errors& errors, const BallShot& shot, std::optional<float> got, std::optional<float> exact)
{
    if (got.has_value() != exact.has_value()) {
        ++errors.wrong;
        errors.band = std::max(errors.band, silhouette_margin(shot));
        return;
    }
    if (!got) return;
    const double sine = miss_distance(shot) / double{shot.ball.radius};
    const double error = tests::ulps_between(*got, *exact);
    errors.worst_all = std::max(errors.worst_all, error);
    if (1 - sine * sine >= 0.01) errors.worst = std::max(errors.worst, error);
}

/// `rays` rays from `distance` radii away, aimed uniformly at a disc of `disc` radii; prints one line of the table.
Errors print_line(const char* name, Intersect* intersect, double distance, double disc, std::uint64_t seed, int rays)
{
    static Intersect* const oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Random random(seed);
    Errors errors;
    for (int i = 0; i < rays; ++i) {
        const Sphere ball{random.in_cube(), random.uniform(0.5F, 2)};
        const BallShot shot = aimed(ball, distance, disc * std::sqrt(random.uniform_double()), random);
        add(errors, shot, intersect(shot.ray, shot.ball), oracle(shot.ray, shot.ball));
    }
    std::printf("%-15s %9.4g %12.4f %10.2f %12.0f %12.0f\n", name, distance, 100.0 * errors.wrong / rays, errors.band,
                errors.worst, errors.worst_all);
    return errors;
}

/// "2541" as "2,541".
std::string with_commas(double number)
{
    std::string text = std::to_string(std::llround(number));
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 400'000;
    std::printf(
        "seed %llu, %d rays a line; from 10 radii on aimed uniformly at a disc of 1.3 radii, nearer at one of 0.99\n",
        static_cast<unsigned long long>(seed), rays);
    std::printf("%-15s %9s %12s %10s %12s %12s\n", "solution", "radii", "wrong, %", "band, ulp", "worst t, ulp",
                "with grazing");
    std::string table =
        "| origin at … radii | 10 | 10² | 10³ | 10⁴ | 10⁵ | 10⁶ |\n|---|---|---|---|---|---|---|\n";  // of the README
    for (const auto& [name, module] :
         {std::pair{"reference", REFERENCE_MODULE}, {"school formula", SCHOOL_FORMULA_MODULE}}) {
        Intersect* const intersect = tests::solution<Intersect>(module);
        for (const double distance : {1.001, 1.01, 1.1, 1.5, 2.0})
            print_line(name, intersect, distance, 0.99, seed, rays);
        std::string wrong = std::string("| ") + name + ": wrong hit or miss, % |";
        std::string worst = std::string("| ") + name + ": worst t, ulp |";
        for (const double distance : {1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
            const Errors errors = print_line(name, intersect, distance, 1.3, seed, rays);
            std::array<char, 32> percent{};
            std::snprintf(percent.data(), percent.size(), " %.2g |", 100.0 * errors.wrong / rays);
            wrong += percent.data();
            worst += " " + with_commas(errors.worst) + " |";
        }
        table += wrong + "\n" + worst + "\n";
    }
    std::printf("\n%s", table.c_str());
}
