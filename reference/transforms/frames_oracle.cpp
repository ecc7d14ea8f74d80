#include <array>
#include <cmath>
#include <cstdint>
#include <umbral/transforms/frames.hpp>

#include "wide_vector.hpp"

// In __float128, by Cramer's rule with cofactors; rounded to float once. The sign of the volume in whole numbers.

namespace umbral::transforms {
namespace {

Wide determinant(const WideVector& a, const WideVector& b, const WideVector& c)
{
    return a[0] * b[1] * c[2] + b[0] * c[1] * a[2] + c[0] * a[1] * b[2] - c[0] * b[1] * a[2] - a[0] * c[1] * b[2] -
           b[0] * a[1] * c[2];
}

/// A sum of products of three floats, in whole multiples of 2^-544: digits of 32 bits, each with the room and the sign
/// of a number of 64.
class ExactSum {
public:
    void add(float a, float b, float c, int sign)
    {
        __extension__ __int128 digits = sign;
        int exponent = 544;
        for (const float factor : {a, b, c}) {
            int power = 0;
            digits *= static_cast<std::int64_t>(std::ldexp(std::frexp(factor, &power), 24));
            exponent += power - 24;
        }
        if (digits == 0) return;
        // Not negative: the least float is 2^23 times 2^-172.
        const auto first = static_cast<std::size_t>(exponent / 32);
        digits *= std::int64_t{1} << (exponent % 32);
        for (std::size_t i = first; i < first + 4; ++i) {
            digits_[i] += static_cast<std::int64_t>(digits % base);
            digits /= base;
        }
    }

    [[nodiscard]] int sign() const
    {
        std::int64_t carry = 0;
        bool any = false;
        for (const std::int64_t digit : digits_) {
            const std::int64_t sum = digit + carry;
            const std::int64_t rest = (sum % base + base) % base;
            any = any || rest != 0;
            carry = (sum - rest) / base;
        }
        return carry < 0 ? -1 : any ? 1 : 0;
    }

private:
    static constexpr std::int64_t base = std::int64_t{1} << 32;
    std::array<std::int64_t, 32> digits_{};
};

/// The coordinates of a vector of the world: v = a x + b y + c z.
glm::vec4 coordinates(const Frame& frame, const WideVector& v, float w)
{
    const WideVector x = widened(frame.x);
    const WideVector y = widened(frame.y);
    const WideVector z = widened(frame.z);
    const Wide all = determinant(x, y, z);
    return {static_cast<float>(determinant(v, y, z) / all), static_cast<float>(determinant(x, v, z) / all),
            static_cast<float>(determinant(x, y, v) / all), w};
}

bool perpendicular(const WideVector& a, const WideVector& b)
{
    return dot(a, b) * dot(a, b) <= Wide(1e-8) * dot(a, a) * dot(b, b);
}

// | |v| - 1 | ≤ 1e-4, of squares.
bool is_unit(const WideVector& v) { return absolute(dot(v, v) - Wide(1 + 1e-8)) <= Wide(2e-4); }

}

glm::mat4 frame_matrix(const Frame& frame)
{
    glm::mat4 result(1);
    for (int row = 0; row < 3; ++row) {
        result[0][row] = frame.x[row];
        result[1][row] = frame.y[row];
        result[2][row] = frame.z[row];
        result[3][row] = frame.origin[row];
    }
    return result;
}

glm::mat4 between_frames(const Frame& from, const Frame& to)
{
    return {coordinates(to, widened(from.x), 0), coordinates(to, widened(from.y), 0),
            coordinates(to, widened(from.z), 0), coordinates(to, widened(from.origin) - widened(to.origin), 1)};
}

glm::mat4 inverse_of_frame(const Frame& frame)
{
    return between_frames({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, frame);
}

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    glm::mat4 result(1);
    const glm::vec3* axes[] = {&frame.x, &frame.y, &frame.z};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result[column][row] = (*axes[row])[column];
        result[3][row] = static_cast<float>(-dot(widened(*axes[row]), widened(frame.origin)));
    }
    return result;
}

int orientation(const Frame& frame)
{
    ExactSum volume;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        volume.add(frame.x[i], frame.y[j], frame.z[k], 1);
        volume.add(frame.x[i], frame.y[k], frame.z[j], -1);
    }
    return volume.sign();
}

FrameKind classify_frame(const Frame& frame)
{
    const WideVector x = widened(frame.x);
    const WideVector y = widened(frame.y);
    const WideVector z = widened(frame.z);
    const int side = orientation(frame);
    if (side == 0) return FrameKind::degenerate;
    if (!perpendicular(x, y) || !perpendicular(y, z) || !perpendicular(z, x)) return FrameKind::oblique;
    if (!is_unit(x) || !is_unit(y) || !is_unit(z)) return FrameKind::orthogonal;
    return side > 0 ? FrameKind::cartesian : FrameKind::orthonormal;
}

}
