// alternative: scale and centre in double, and the region from the aspect ratio
#include <umbral/pipeline/region.hpp>

namespace umbral::pipeline {

static glm::dvec3 scale_of(const Box& region)
{
    const glm::dvec3 size = glm::dvec3(region.high) - glm::dvec3(region.low);
    return {size.x != 0 ? 2 / size.x : 0, size.y != 0 ? 2 / size.y : 0, size.z != 0 ? 2 / size.z : 0};
}

static glm::dvec3 centre_of(const Box& region) { return (glm::dvec3(region.low) + glm::dvec3(region.high)) / 2.0; }

glm::mat4 projection_of(const Box& region)
{
    return glm::mat4(glm::translate(glm::scale(glm::dmat4(1), scale_of(region)), -centre_of(region)));
}

glm::vec3 ndc_of(const Box& region, const glm::vec3& point)
{
    return glm::vec3(scale_of(region) * (glm::dvec3(point) - centre_of(region)));
}

Box visible_region(const Box& contents, int width, int height)
{
    if (width < 1 || height < 1) return contents;
    const double aspect = static_cast<double>(width) / height;
    const double dx = contents.high.x - contents.low.x;
    const double dy = contents.high.y - contents.low.y;
    const glm::dvec3 centre = centre_of(contents);
    Box region = contents;
    if (std::abs(dx) < aspect * std::abs(dy)) {
        const double half = std::abs(dy) * aspect / 2 * (dx < 0 ? -1 : 1);
        region.low.x = static_cast<float>(centre.x - half);
        region.high.x = static_cast<float>(centre.x + half);
    } else {
        const double half = std::abs(dx) / aspect / 2 * (dy < 0 ? -1 : 1);
        region.low.y = static_cast<float>(centre.y - half);
        region.high.y = static_cast<float>(centre.y + half);
    }
    return region;
}

void keep_proportions(GLFWwindow* window)
{
    const auto resized = [](GLFWwindow* w, int width, int height) {
        if (width == 0 || height == 0) return;
        auto* viewer = static_cast<Viewer*>(glfwGetWindowUserPointer(w));
        viewer->show(glm::ivec2(width, height), projection_of(visible_region(viewer->contents(), width, height)));
    };
    glfwSetFramebufferSizeCallback(window, resized);
    int width, height;
    glfwGetFramebufferSize(window, &width, &height);
    resized(window, width, height);
}

}
