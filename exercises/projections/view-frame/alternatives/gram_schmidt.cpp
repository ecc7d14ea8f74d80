// alternative: y by removing from up what lies along z, x as y × z; the view by three rotations
#include <umbral/projections/view_frame.hpp>

namespace umbral::projections {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

glm::dmat3 about_y(double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

glm::dmat3 about_x(double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
}

glm::dmat3 about_z(double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

}

std::optional<ViewFrame> view_frame(const ViewParameters& view)
{
    const glm::dvec3 normal(view.normal);
    const glm::dvec3 up(view.up);
    if (normal == glm::dvec3(0) || up == glm::dvec3(0)) return std::nullopt;
    const glm::dvec3 z = glm::normalize(normal);
    const glm::dvec3 direction = glm::normalize(up);
    glm::dvec3 y = direction - glm::dot(direction, z) * z;
    if (glm::length(y) < 1e-6) return std::nullopt;
    y = glm::normalize(y);
    y = glm::normalize(y - glm::dot(y, z) * z);
    return ViewFrame{glm::vec3(glm::cross(y, z)), glm::vec3(y), glm::vec3(z),
                     glm::vec3(glm::dvec3(view.target) + normal)};
}

ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees, float elevation_degrees,
                         float roll_degrees)
{
    const glm::dmat3 camera =
        about_y(azimuth_degrees * degree) * about_x(-elevation_degrees * degree) * about_z(-roll_degrees * degree);
    return {target, glm::vec3(camera[1]), glm::vec3(camera[2] * double{distance})};
}

}
