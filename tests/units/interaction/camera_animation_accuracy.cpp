// Prints how wrong the view of a flight far from the origin is: the table in the statement of
// interaction/camera-animation. Usage: camera-animation-accuracy [SEED]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <interaction/camera-animation/flights.hpp>
#include <umbral/projections/view.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::interaction;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const auto oracle = tests::solution<glm::mat4(const CameraFlight&, float)>(ORACLE_MODULE);
    std::printf("seed %llu; worst entry of the rotation in 20,000 flights, against the oracle\n%-12s %12s %12s\n",
                static_cast<unsigned long long>(seed), "distance", "rounded pose", "reference");
    for (const float distance : {1.0F, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F}) {
        Random random(seed);
        double rounded = 0;
        double reference = 0;
        for (int i = 0; i < 20'000; ++i) {
            CameraFlight flight = random_flight(random);
            const glm::vec3 place = distance * random.unit_vector();
            for (glm::vec3* const end : {&flight.eye_from, &flight.eye_to, &flight.target_from, &flight.target_to})
                *end += place;
            const float seconds = flight.duration * random.uniform();
            const glm::mat4 exact = oracle(flight, seconds);
            const auto [eye, target] = flight_pose(flight, seconds);
            const glm::mat4 naive = projections::view_matrix(eye, target, {0, 1, 0});
            rounded = std::max(rounded, tests::rotation_error(naive, exact));
            reference = std::max(reference, tests::rotation_error(flight_view(flight, seconds), exact));
        }
        std::printf("%-12g %12.1e %12.1e\n", static_cast<double>(distance), rounded, reference);
    }
}
