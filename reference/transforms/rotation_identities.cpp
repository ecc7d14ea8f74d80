// Based on: C. Ureña. Informática Gráfica, tema 2, "transformaciones de rotación elementales en 3D". 2021; the
// reduction to an eighth of a turn as in W. J. Cody, W. Waite. Software Manual for the Elementary Functions. 1980: fmod
// and differences of near numbers are exact.

#include <cmath>
#include <numbers>
#include <umbral/transforms/rotation_identities.hpp>

namespace umbral::transforms {
namespace {

struct Direction {
    double cosine;
    double sine;
};

Direction direction_at(float degrees)
{
    // Exact: the rest is a multiple of the angle's last digit, from -180 to 180, and then from -45 to 45.
    const double rest = std::remainder(double{degrees}, 360.0);
    const double quarters = std::nearbyint(rest / 90);
    const double radians = (rest - 90 * quarters) * (std::numbers::pi / 180);
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    switch (static_cast<int>(quarters) & 3) {
        case 0: return {c, s};
        case 1: return {-s, c};
        case 2: return {-c, -s};
        default: return {s, -c};
    }
}

// About x, y turns towards z; about y, z towards x; about z, x towards y.
glm::dvec3 turned(glm::dvec3 v, const ElementaryTurn& turn)
{
    const auto [c, s] = direction_at(turn.degrees);
    const int from = (static_cast<int>(turn.axis) + 1) % 3;
    const int to = (from + 1) % 3;
    const double along = v[from];
    const double aside = v[to];
    v[from] = c * along - s * aside;
    v[to] = s * along + c * aside;
    return v;
}

}

glm::vec3 elementary_rotation(const glm::vec3& vector, const ElementaryTurn& turn)
{
    return glm::vec3(turned(glm::dvec3(vector), turn));
}

glm::mat3 elementary_matrix(const ElementaryTurn& turn)
{
    return {elementary_rotation({1, 0, 0}, turn), elementary_rotation({0, 1, 0}, turn),
            elementary_rotation({0, 0, 1}, turn)};
}

glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns)
{
    glm::dvec3 v(vector);
    for (const ElementaryTurn& turn : turns) v = turned(v, turn);
    return glm::vec3(v);
}

}
