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
    fragments.clear();
    fragments.shrink_to_fit();
    std::vector<Fragment> others(1000, Fragment{{1, 1}, 0, {0, 0, 1}});
    fragments.swap(others);
}
}
