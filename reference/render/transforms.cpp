#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/draw_list.hpp"
#include "scene/motion.hpp"

namespace umbral::render {
namespace {

struct Matrix {
    glm::dmat4 operator()(const scene::Translate& translate) const
    {
        return glm::translate(glm::dmat4(1), glm::dvec3(translate.by));
    }
    glm::dmat4 operator()(const scene::Rotate& rotate) const
    {
        return glm::rotate(glm::dmat4(1), glm::radians(double{rotate.degrees}), normalize(glm::dvec3(rotate.axis)));
    }
    glm::dmat4 operator()(const scene::Scale& scale) const { return glm::scale(glm::dmat4(1), glm::dvec3(scale.by)); }
    /// What moves is where it is at time 0; at_time (scene/motion.hpp) shows it at another.
    template <class Moving>
    glm::dmat4 operator()(const Moving& moving) const
    {
        return std::visit(*this, scene::at_time(moving, 0));
    }
};

}

glm::mat4 projection_matrix(const scene::Camera& camera, double aspect)
{
    const double cotangent = 1 / std::tan(glm::radians(double{camera.fovy_degrees}) / 2);
    const double near = camera.near;
    const double far = camera.far;
    glm::dmat4 matrix(0);
    matrix[0][0] = cotangent / aspect;
    matrix[1][1] = cotangent;
    matrix[2][2] = -(far + near) / (far - near);
    matrix[2][3] = -1;
    matrix[3][2] = -2 * far * near / (far - near);
    return glm::mat4(matrix);
}

glm::mat4 model_matrix(const std::vector<scene::Transform>& transforms)
{
    glm::dmat4 product(1);
    for (const scene::Transform& transform : transforms) product = std::visit(Matrix{}, transform) * product;
    return glm::mat4(product);
}

}
