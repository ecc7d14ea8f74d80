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
    for (int i = 0; i < 100000; ++i) fragments.push_back({{3, 3}, 0.5F, {1, 0, 0}});
}
}
