#include <cmath>
#include <numbers>
#include <umbral/transforms/rotation_identities.hpp>

// With at least 64 bits, rounded to float once: the whole chain as one 3 × 3 matrix, where the reference turns the
// vector.

namespace umbral::transforms {
namespace {

using Wide = long double;
using WideMatrix = glm::mat<3, 3, Wide>;

// Sine of an angle in degrees, brought to -90 … 90 exactly first.
Wide sine_of(Wide degrees)
{
    Wide rest = std::remainder(degrees, Wide(360));
    if (rest > 90) rest = 180 - rest;
    if (rest < -90) rest = -180 - rest;
    if (std::abs(rest) == 90) return rest / 90;
    return std::sin(rest * (std::numbers::pi_v<Wide> / 180));
}

WideMatrix wide_matrix(const ElementaryTurn& turn)
{
    // cos α = sin(α + 90°), where the sum is exact once whole turns are taken off.
    const Wide reduced = std::remainder(Wide(turn.degrees), Wide(360));
    const Wide sine = sine_of(reduced);
    const Wide cosine = sine_of(90 - std::abs(reduced));
    const int kept = static_cast<int>(turn.axis);
    const int from = kept == 2 ? 0 : kept + 1;
    const int to = 3 - kept - from;
    WideMatrix m(0);
    m[kept][kept] = 1;
    m[from][from] = cosine;
    m[to][to] = cosine;
    m[from][to] = sine;
    m[to][from] = -sine;
    return m;
}

}

glm::vec3 elementary_rotation(const glm::vec3& vector, const ElementaryTurn& turn)
{
    return glm::vec3(wide_matrix(turn) * glm::vec<3, Wide>(vector));
}

glm::mat3 elementary_matrix(const ElementaryTurn& turn) { return glm::mat3(wide_matrix(turn)); }

glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns)
{
    WideMatrix all(1);
    for (const ElementaryTurn& turn : turns) all = wide_matrix(turn) * all;
    return glm::vec3(all * glm::vec<3, Wide>(vector));
}

}
