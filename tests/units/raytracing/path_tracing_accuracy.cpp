#include <cmath>
#include <cstdio>
#include <raytracing/cast.hpp>
#include <raytracing/path-tracing/room.hpp>

// Noise of the goal picture: the standard deviation of a pixel's green light (root mean square over the pixels), as a
// share of the picture's mean.
int main()
{
    using namespace umbral;
    using namespace umbral::raytracing;
    const DiffuseRoom room = cornell_room();
    const Camera camera{{0, 1, 3.9F}, {0, 1, 0}, 0.33F};
    constexpr int size = 24;
    constexpr int repeats = 64;
    Random random(20281);
    std::printf("%8s %18s\n", "samples", "noise of a pixel");
    for (const int samples : {1, 4, 16, 64}) {
        double noise = 0;
        double light = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Ray ray = camera_ray(camera, size, size, glm::vec2(x, y) + 0.5F);
                double sum = 0;
                double squares = 0;
                for (int i = 0; i < repeats; ++i) {
                    const double green = path_light(room, ray, all_bounces, samples, random).g;
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
