// The same in double, rounded once: differences of floats are exact in double unless the numbers are 2^29 times as
// large as each other.

#include <algorithm>
#include <cmath>
#include <umbral/pipeline/region.hpp>

namespace umbral::pipeline {
namespace {

double scale_of(const Box& region, int axis)
{
    const double size = double{region.high[axis]} - double{region.low[axis]};
    return size == 0 ? 0 : 2 / size;
}

double centre_of(const Box& region, int axis) { return 0.5 * (double{region.low[axis]} + double{region.high[axis]}); }

void on_framebuffer_size(GLFWwindow* window, int width, int height)
{
    if (width <= 0 || height <= 0) return;
    Viewer& viewer = *static_cast<Viewer*>(glfwGetWindowUserPointer(window));
    viewer.show({width, height}, projection_of(visible_region(viewer.contents(), width, height)));
}

}

glm::mat4 projection_of(const Box& region)
{
    glm::dmat4 projection(1);
    for (int axis = 0; axis < 3; ++axis) {
        projection[axis][axis] = scale_of(region, axis);
        projection[3][axis] = -scale_of(region, axis) * centre_of(region, axis);
    }
    return glm::mat4(projection);
}

glm::vec3 ndc_of(const Box& region, const glm::vec3& point)
{
    glm::dvec3 ndc(0);
    for (int axis = 0; axis < 3; ++axis)
        ndc[axis] = scale_of(region, axis) * (double{point[axis]} - centre_of(region, axis));
    return glm::vec3(ndc);
}

Box visible_region(const Box& contents, int width, int height)
{
    if (width <= 0 || height <= 0) return contents;
    const glm::dvec2 size = abs(glm::dvec2(contents.high) - glm::dvec2(contents.low));
    const glm::dvec2 fitting = glm::max(size, glm::dvec2(size.y * width / height, size.x * height / width));
    Box region = contents;
    for (int axis = 0; axis < 2; ++axis) {
        const double half =
            std::copysign(0.5 * fitting[axis], double{contents.high[axis]} - double{contents.low[axis]});
        region.low[axis] = static_cast<float>(centre_of(contents, axis) - half);
        region.high[axis] = static_cast<float>(centre_of(contents, axis) + half);
    }
    return region;
}

void keep_proportions(GLFWwindow* window)
{
    glfwSetFramebufferSizeCallback(window, on_framebuffer_size);
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window, &size.x, &size.y);
    on_framebuffer_size(window, size.x, size.y);
}

}
