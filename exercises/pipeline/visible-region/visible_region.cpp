#include <umbral/pipeline/region.hpp>

namespace umbral::pipeline {

glm::mat4 projection_of(const Box& region)
{
    // TODO: on each axis the scale is 2 / (high - low), and the centre of the box goes to 0. What if the box is flat
    // there?
    return not_implemented<glm::mat4>(region);
}

glm::vec3 ndc_of(const Box& region, const glm::vec3& point)
{
    // TODO: the same, point by point. First the differences, then everything else.
    return not_implemented<glm::vec3>(region, point);
}

Box visible_region(const Box& contents, int width, int height)
{
    // TODO: make the box wider or higher, on both sides alike, until it has the proportions of the viewport.
    return not_implemented<Box>(contents, width, height);
}

void keep_proportions(GLFWwindow* window)
{
    // TODO: above, write a callback void on_framebuffer_size(GLFWwindow* window, int width, int height) that calls
    // show(). Register it here with glfwSetFramebufferSizeCallback, and call it once with the present size. Delete the
    // next line.
    (void)not_implemented<int>(window);
}

}
