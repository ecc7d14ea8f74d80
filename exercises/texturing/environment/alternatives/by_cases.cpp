// alternative: in float but for the rim of the ball; scaled by the largest coordinate; the box by cases
#include <algorithm>
#include <cmath>
#include <umbral/texturing/environment.hpp>

namespace umbral::texturing {
namespace {

constexpr float pi = 3.14159265F;

float largest(const glm::vec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

}

glm::vec3 mirrored_direction(const glm::vec3& to_eye, const glm::vec3& normal) { return -reflect(to_eye, normal); }

BoxPlace box_place(const glm::vec3& direction)
{
    const glm::vec3 d = direction / largest(direction);
    const auto at = [](BoxFace face, float a, float b) { return BoxPlace{face, {(a + 1) / 2, (b + 1) / 2}}; };
    if (d.x == 1) return at(BoxFace::right, d.z, d.y);
    if (d.x == -1) return at(BoxFace::left, -d.z, d.y);
    if (d.y == 1) return at(BoxFace::top, d.x, d.z);
    if (d.y == -1) return at(BoxFace::bottom, d.x, -d.z);
    return d.z == 1 ? at(BoxFace::back, -d.x, d.y) : at(BoxFace::front, d.x, d.y);
}

glm::vec3 box_direction(const BoxPlace& place)
{
    const float a = 2 * place.uv.x - 1;
    const float b = 2 * place.uv.y - 1;
    const glm::vec3 directions[] = {{1, b, a}, {-1, b, -a}, {a, 1, b}, {a, -1, -b}, {-a, b, 1}, {a, b, -1}};
    return directions[static_cast<int>(place.face)];
}

glm::vec2 panorama_place(const glm::vec3& direction)
{
    const glm::vec3 d = direction / largest(direction);
    const float flat = length(glm::vec2(d.x, d.z));
    float u = 0.5F;
    if (d.x == 0 && d.z > 0)
        u = 1;
    else if (flat > 0)
        u += std::atan2(d.x, -d.z) / (2 * pi);
    return {u, 0.5F + std::atan2(d.y, flat) / pi};
}

glm::vec3 panorama_direction(glm::vec2 uv)
{
    const float alpha = 2 * pi * (uv.x - 0.5F);
    const float beta = pi * (uv.y - 0.5F);
    return std::cos(beta) * glm::vec3(std::sin(alpha), 0, -std::cos(alpha)) + glm::vec3(0, std::sin(beta), 0);
}

glm::vec2 sphere_place(const glm::vec3& direction)
{
    const glm::vec3 d = direction / largest(direction);
    const float flat = length(glm::vec2(d));
    if (flat == 0) return d.z > 0 ? glm::vec2(0.5F) : glm::vec2(1, 0.5F);
    const float radius = std::sin(std::atan2(flat, d.z) / 2);
    return glm::vec2(0.5F) + radius / 2 * glm::vec2(d) / flat;
}

glm::vec3 sphere_direction(glm::vec2 uv)
{
    const double x = 2 * double{uv.x} - 1;
    const double y = 2 * double{uv.y} - 1;
    const double rest = 1 - x * x - y * y;  // near the rim floats would lose half of its digits
    if (rest <= 0) return {0, 0, -1};
    const double z = std::sqrt(rest);
    return {2 * x * z, 2 * y * z, 2 * rest - 1};
}

}
