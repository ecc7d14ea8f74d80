#include <limits>
#include <umbral/pipeline/rasterize.hpp>
namespace umbral::pipeline {
void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height, std::vector<Fragment>& fragments)
{
    (void)triangle;
    (void)width;
    (void)height;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    (void)nan;
    for (int y = 0; y < height && y < 64; ++y)
        for (int x = 0; x < width && x < 64; ++x) fragments.push_back({{x, y}, x % 3 == 0 ? nan : x % 3 == 1 ? 1e38F : -1.0F / 0.0F, {nan, 1e38F, -1e38F}});
}
}
