// Prints how far cameras drift from the oracle's in a long session: the table in the statement of
// interaction/orbit-camera. Usage: orbit-camera-accuracy [SEED]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <interaction/support.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::interaction;
using MakeCamera = std::unique_ptr<OrbitCamera>(const OrbitCameraSettings&);

/// The session of the driver's case "a million turns"; the worst error of the rotation after so many turns, and of
/// those before.
int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    constexpr std::array turns{10, 100, 1000, 10'000, 100'000, 1'000'000, 10'000'000};
    const OrbitCameraSettings settings{.distance = 3, .yaw = 0.3};
    std::printf("seed %llu; worst entry of the rotation, against the oracle\n%-28s",
                static_cast<unsigned long long>(seed), "turns, 5 with each drag");
    for (const int shown : turns) std::printf(" %9d", shown);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE},
                                       {"double, never wrapped", LOOK_AT_MODULE},
                                       {"float, wrapped each time", ANGLES_IN_FLOAT_MODULE}}) {
        const auto camera = tests::solution<MakeCamera>(module)(settings);
        const auto exact = tests::solution<MakeCamera>(ORACLE_MODULE)(settings);
        Random random(seed);
        double worst = 0;
        int drags = 0;
        std::printf("\n%-28s", name);
        for (const int shown : turns) {
            for (; drags < shown / 5; ++drags) {
                const double right = 4800 + random_pixels(random, 4800);
                const double up = random_pixels(random, 60);
                camera->drag(right, up);
                exact->drag(right, up);
                if (drags < 100 || drags % 50 == 0)
                    worst = std::max(worst, tests::rotation_error(camera->view(), exact->view()));
            }
            std::printf(" %9.1e", worst);
        }
    }
    std::printf("\n");
}
