// Prints how far OpenGL's light lies from its formula, by the exponent: the table in the statement of
// lighting/fixed-pipeline. Usage: fixed-pipeline-accuracy [SEED [CASES]]

#include <cstdio>
#include <cstdlib>
#include <umbral/gl/context.hpp>

#include "exact_light.hpp"

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 1000;
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    const LinearFrame frame(1, 1);
    std::printf("seed %llu, %d random vertices; largest error of a channel\n", static_cast<unsigned long long>(seed),
                cases);
    for (const float e : {1.0F, 10.0F, 50.0F, 128.0F}) {
        Random random(seed);
        double worst = 0;
        double brightest = 0;
        for (int i = 0; i < cases; ++i) {
            Probe probe = random_probe(random);
            // Backs are seen as triangles, across which OpenGL interpolates.
            if (probe.seen_from_behind) continue;
            probe.material.shininess = e;
            const glm::dvec3 exact = exact_light(probe);
            worst = std::max(worst, largest(light_by_opengl(frame, probe) - exact));
            brightest = std::max(brightest, largest(exact));
        }
        std::printf("e %3.0f  %7.1e of up to %.1f\n", static_cast<double>(e), worst, brightest);
    }
}
