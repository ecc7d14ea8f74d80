// alternative: float throughout; the share of the box on either side of the point, and products instead of quotients
#include <umbral/pipeline/region.hpp>

namespace umbral::pipeline {
namespace {

constexpr int axes[] = {0, 1, 2};

void resized(GLFWwindow* window, int width, int height)
{
    if (width * height == 0) return;
    Viewer* viewer = static_cast<Viewer*>(glfwGetWindowUserPointer(window));
    const Box region = visible_region(viewer->contents(), width, height);
    viewer->show({width, height}, projection_of(region));
}

}

glm::mat4 projection_of(const Box& region)
{
    glm::mat4 result(1);
    for (const int i : axes) {
        const bool flat = region.low[i] == region.high[i];
        const float s = flat ? 0 : 2 / (region.high[i] - region.low[i]);
        const float c = (region.low[i] + region.high[i]) / 2;
        result[i][i] = s;
        result[3][i] = -s * c;
    }
    return result;
}

glm::vec3 ndc_of(const Box& region, const glm::vec3& point)
{
    glm::vec3 result(0);
    for (const int i : axes)
        if (region.low[i] != region.high[i]) {
            const float below = (point[i] - region.low[i]) / (region.high[i] - region.low[i]);
            const float above = (region.high[i] - point[i]) / (region.high[i] - region.low[i]);
            result[i] = below - above;
        }
    return result;
}

Box visible_region(const Box& contents, int width, int height)
{
    Box region = contents;
    if (width == 0 || height == 0) return region;
    const float w = static_cast<float>(width), h = static_cast<float>(height);
    const glm::vec3 extent = contents.high - contents.low;
    const bool wider = w * std::abs(extent.y) > h * std::abs(extent.x);
    const int axis = wider ? 0 : 1;
    float margin = ((wider ? std::abs(extent.y) * w / h : std::abs(extent.x) * h / w) - std::abs(extent[axis])) / 2;
    if (extent[axis] < 0) margin = -margin;
    region.low[axis] -= margin;
    region.high[axis] += margin;
    return region;
}

void keep_proportions(GLFWwindow* window)
{
    glfwSetFramebufferSizeCallback(window, resized);
    int size[2];
    glfwGetFramebufferSize(window, size, size + 1);
    resized(window, size[0], size[1]);
}

}
