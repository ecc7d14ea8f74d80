// alternative: the whole chain as one matrix in double, with sines by way of fmod and a table of the exact ones
#include <cmath>
#include <umbral/transforms/rotation_identities.hpp>

namespace umbral::transforms {
namespace {

constexpr double degree = 0.017453292519943295;

// From 0 to 360, symmetric in each quarter, so that no sine of a multiple of 90 is ever computed.
double sine(double degrees)
{
    double rest = std::fmod(degrees, 360.0);
    if (rest < 0) rest += 360;
    if (rest == 0 || rest == 180) return 0;
    if (rest == 90) return 1;
    if (rest == 270) return -1;
    return std::sin((rest > 180 ? rest - 360 : rest) * degree);
}

glm::dmat3 matrix(const ElementaryTurn& turn)
{
    const double whole = std::fmod(double{turn.degrees}, 360.0);
    const double s = sine(whole);
    const double c = sine(whole + 90);
    switch (turn.axis) {
        case WorldAxis::x: return {1, 0, 0, 0, c, s, 0, -s, c};
        case WorldAxis::y: return {c, 0, -s, 0, 1, 0, s, 0, c};
        default: return {c, s, 0, -s, c, 0, 0, 0, 1};
    }
}

}

glm::vec3 elementary_rotation(const glm::vec3& vector, const ElementaryTurn& turn)
{
    return glm::vec3(matrix(turn) * glm::dvec3(vector));
}

glm::mat3 elementary_matrix(const ElementaryTurn& turn) { return glm::mat3(matrix(turn)); }

glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns)
{
    glm::dmat3 all(1);
    for (const ElementaryTurn& turn : turns) all = matrix(turn) * all;
    return glm::vec3(all * glm::dvec3(vector));
}

}
