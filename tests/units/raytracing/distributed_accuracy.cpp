#include <cmath>
#include <cstdio>
#include <raytracing/distributed/scenes.hpp>

// Noise of the goal picture: the standard deviation of a pixel's green light (root mean square over the pixels), as a
// share of the picture's mean.
int main()
{
    using namespace umbral;
    using namespace umbral::raytracing;
    const StillLife life = goal_still_life();
    constexpr int size = 24;
    constexpr int repeats = 64;
    Random random(20282);
    std::printf("%8s %18s\n", "samples", "noise of a pixel");
    for (const int samples : {1, 4, 16, 64}) {
        double noise = 0;
        double light = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                double sum = 0;
                double squares = 0;
                for (int i = 0; i < repeats; ++i) {
                    const double green = pixel_light(life, goal_camera(), {size, size}, {x, y}, samples, random).g;
                    sum += green / repeats;
                    squares += green * green / repeats;
                }
                light += sum;
                noise += std::max(0.0, squares - sum * sum) * repeats / (repeats - 1);
            }
        light /= size * size;
        std::printf("%8d %16.1f %%\n", samples, 100 * std::sqrt(noise / (size * size)) / light);
    }
}
