// Prints how far cameras drift from the oracle's in a long session: the table in the statement of
// interaction/three-mode-camera. Usage: three-mode-camera-accuracy [SEED]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <interaction/three-mode-camera/steps.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::interaction;
using MakeCamera = std::unique_ptr<ThreeModeCamera>(const ThreeModeSettings&);

/// The worst error of the rotation after so many steps, and after those before; modes change every hundred steps.
int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    constexpr std::array steps{100, 1000, 10'000, 100'000, 1'000'000};
    std::printf("seed %llu; worst entry of the rotation, against the oracle\n%-28s",
                static_cast<unsigned long long>(seed), "steps of 0 to pi");
    for (const int shown : steps) std::printf(" %9d", shown);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE},
                                       {"double, never wrapped", COURSE_STATE_MODULE},
                                       {"float", IN_FLOAT_MODULE}}) {
        const auto camera = tests::solution<MakeCamera>(module)({.azimuth = 0.3});
        const auto exact = tests::solution<MakeCamera>(ORACLE_MODULE)({.azimuth = 0.3});
        Random random(seed);
        double worst = 0;
        double elevation = 0;
        int done = 0;
        std::printf("\n%-28s", name);
        for (const int shown : steps) {
            for (; done < shown; ++done) {
                const bool moves = done / 100 % 3 == 1;
                const double right = std::numbers::pi * random.uniform_double();
                const double up = random_length(random, 1.5) - elevation;
                if (!moves) elevation += up;
                for (ThreeModeCamera* each : {camera.get(), exact.get()}) {
                    each->move_xy(moves ? 0.1 * right : right, up);
                    if (done % 100 == 99) each->next_mode();
                }
                if (done < 100 || done % 50 == 0)
                    worst = std::max(worst, tests::rotation_error(camera->view(), exact->view()));
            }
            std::printf(" %9.1e", worst);
        }
    }
    std::printf("\n");
}
