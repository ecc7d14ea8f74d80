// Based on: the course's projection matrix of a visible region, and its problem 1.7; N. J. Higham. Accuracy and
// Stability of Numerical Algorithms. 2nd edition, 2002 (section 2.5: differences of close floating-point numbers are
// exact).

#include <algorithm>
#include <cmath>
#include <umbral/pipeline/region.hpp>

namespace umbral::pipeline {
namespace {

void on_framebuffer_size(GLFWwindow* window, int width, int height)
{
    if (width <= 0 || height <= 0) return;
    Viewer& viewer = *static_cast<Viewer*>(glfwGetWindowUserPointer(window));
    viewer.show({width, height}, projection_of(visible_region(viewer.contents(), width, height)));
}

}

glm::mat4 projection_of(const Box& region)
{
    glm::mat4 projection(0);
    projection[3].w = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = region.high[axis] - region.low[axis];
        if (size == 0) continue;
        projection[axis][axis] = 2 / size;
        projection[3][axis] = -(region.low[axis] + region.high[axis]) / size;
    }
    return projection;
}

glm::vec3 ndc_of(const Box& region, const glm::vec3& point)
{
    glm::vec3 ndc(0);
    for (int axis = 0; axis < 3; ++axis) {
        const float size = region.high[axis] - region.low[axis];
        // Far from the origin the centre has no exact float, but both differences have.
        if (size != 0) ndc[axis] = ((point[axis] - region.low[axis]) + (point[axis] - region.high[axis])) / size;
    }
    return ndc;
}

Box visible_region(const Box& contents, int width, int height)
{
    if (width <= 0 || height <= 0) return contents;
    const glm::dvec3 low(contents.low);
    const glm::dvec3 high(contents.high);
    const glm::dvec3 size = abs(high - low);
    // Products instead of quotients: contents may have no height.
    const int axis = width * size.y > height * size.x ? 0 : 1;
    const double fitting = axis == 0 ? size.y * width / height : size.x * height / width;
    const double margin = std::copysign(std::max(0.0, 0.5 * (fitting - size[axis])), high[axis] - low[axis]);
    Box region = contents;
    region.low[axis] = static_cast<float>(low[axis] - margin);
    region.high[axis] = static_cast<float>(high[axis] + margin);
    return region;
}

void keep_proportions(GLFWwindow* window)
{
    glfwSetFramebufferSizeCallback(window, on_framebuffer_size);
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    on_framebuffer_size(window, width, height);
}

}
