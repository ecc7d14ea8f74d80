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
    for (const int x : {std::numeric_limits<int>::min(), -1, 0, std::numeric_limits<int>::max()})
        for (const int y : {std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 7})
            fragments.push_back({{x, y}, 0.5F, {1, 0, 0}});
}
}
