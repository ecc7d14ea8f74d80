// alternative: both surfaces as symmetric 4 x 4 matrices, p Q p = 0, for rays made unit and begun near the y axis
#include <algorithm>
#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>
#include <vector>

namespace umbral::raytracing {
namespace {

using Matrix = glm::dmat4;

Matrix cylinder_form()
{
    Matrix q(0.0);
    q[0][0] = q[2][2] = 1;
    q[3][3] = -1;
    return q;
}

Matrix cone_form()
{
    Matrix q(0.0);
    q[0][0] = q[2][2] = 1;
    q[1][1] = -1;
    q[1][3] = q[3][1] = 1;
    q[3][3] = -1;
    return q;
}

double form(const Matrix& q, const glm::dvec4& u, const glm::dvec4& v) { return dot(u, q * v); }

std::optional<float> intersect(const Ray& ray, const Matrix& q)
{
    const double speed = length(glm::dvec3(ray.direction));
    if (!(speed > 0)) return std::nullopt;
    const glm::dvec3 way = glm::dvec3(ray.direction) / speed;
    // Walk to the point nearest to the middle of the axis first: the numbers there are small.
    const glm::dvec3 middle(0, 0.5, 0);
    const double walked = dot(middle - glm::dvec3(ray.origin), way);
    const glm::dvec4 p(glm::dvec3(ray.origin) + walked * way, 1);
    const glm::dvec4 d(way, 0);

    const double a = form(q, d, d);
    const double h = form(q, p, d);
    const double c = form(q, p, p);
    std::vector<double> places;
    if (a == 0) {
        if (h != 0) places.push_back(-c / (2 * h));
    } else if (h * h >= a * c) {
        const double root = std::sqrt(h * h - a * c);
        const double sum = h < 0 ? h - root : h + root;
        places.push_back(-sum / a);
        if (sum != 0) places.push_back(-c / sum);
    }
    std::sort(places.begin(), places.end());
    for (const double s : places) {
        const double t = (walked + s) / speed;
        const double y = p.y + s * way.y;
        if (0 <= y && y <= 1 && static_cast<float>(t) > ray.t_min && static_cast<float>(t) < ray.t_max)
            return static_cast<float>(t);
    }
    return std::nullopt;
}

float field(const Matrix& q, const glm::vec3& p)
{
    const glm::dvec4 place(glm::dvec3(p), 1);
    return static_cast<float>(form(q, place, place));
}

}

float unit_cylinder_field(const glm::vec3& p) { return field(cylinder_form(), p); }
float unit_cone_field(const glm::vec3& p) { return field(cone_form(), p); }
std::optional<float> intersect_unit_cylinder(const Ray& ray) { return intersect(ray, cylinder_form()); }
std::optional<float> intersect_unit_cone(const Ray& ray) { return intersect(ray, cone_form()); }

}
