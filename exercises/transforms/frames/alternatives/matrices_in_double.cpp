// alternative: general inverses of 4 × 4 matrices in double; the sign by passes over the twelve parts of the
// determinant until the last holds their sum
#include <array>
#include <cmath>
#include <umbral/transforms/frames.hpp>

namespace umbral::transforms {
namespace {

glm::dmat4 wide(const Frame& frame)
{
    return {glm::dvec4(frame.x, 0), glm::dvec4(frame.y, 0), glm::dvec4(frame.z, 0), glm::dvec4(frame.origin, 1)};
}

bool perpendicular(const glm::vec3& a, const glm::vec3& b)
{
    return std::abs(dot(normalize(glm::dvec3(a)), normalize(glm::dvec3(b)))) <= 1e-4;
}

bool unit(const glm::vec3& v) { return std::abs(length(glm::dvec3(v)) - 1) <= 1e-4; }

}

glm::mat4 frame_matrix(const Frame& frame) { return glm::mat4(wide(frame)); }

glm::mat4 inverse_of_frame(const Frame& frame) { return glm::mat4(glm::inverse(wide(frame))); }

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    const glm::mat3 back = glm::transpose(glm::mat3(frame.x, frame.y, frame.z));
    glm::mat4 m(back);
    m[3] = glm::vec4(-(back * frame.origin), 1);
    return m;
}

glm::mat4 between_frames(const Frame& from, const Frame& to) { return glm::mat4(glm::inverse(wide(to)) * wide(from)); }

int orientation(const Frame& frame)
{
    std::array<double, 12> parts{};
    std::size_t count = 0;
    for (int i = 0; i < 3; ++i) {
        for (const int j : {(i + 1) % 3, (i + 2) % 3}) {
            const int k = 3 - i - j;
            const double pair = (j == (i + 1) % 3 ? 1.0 : -1.0) * double{frame.x[i]} * double{frame.y[j]};
            parts[count++] = pair * double{frame.z[k]};
            parts[count] = std::fma(pair, double{frame.z[k]}, -parts[count - 1]);
            ++count;
        }
    }
    // Each pass carries sums to the right and leaves their roundings behind: after as many as there are parts nothing
    // is left to carry.
    for (std::size_t pass = 0; pass < parts.size(); ++pass) {
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const double sum = parts[i - 1] + parts[i];
            const double added = sum - parts[i];
            parts[i - 1] = (parts[i] - (sum - added)) + (parts[i - 1] - added);
            parts[i] = sum;
        }
    }
    return (parts.back() > 0) - (parts.back() < 0);
}

FrameKind classify_frame(const Frame& frame)
{
    if (orientation(frame) == 0) return FrameKind::degenerate;
    if (!perpendicular(frame.x, frame.y) || !perpendicular(frame.x, frame.z) || !perpendicular(frame.y, frame.z))
        return FrameKind::oblique;
    if (!unit(frame.x) || !unit(frame.y) || !unit(frame.z)) return FrameKind::orthogonal;
    return orientation(frame) == 1 ? FrameKind::cartesian : FrameKind::orthonormal;
}

}
