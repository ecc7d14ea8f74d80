#include <cmath>
#include <numbers>
#include <umbral/meshes/revolution.hpp>

#include "wide.hpp"

// The definition with 64 bits and more, rounded to float once. Cosine and sine of a fraction of a turn come from the
// series of the angle in its octant, in __float128; where the compiler has none (arm64), long double is as wide. Square
// roots by one step of Newton from long double.

namespace umbral::meshes {
namespace {

struct WideVector {
    Wide x, y;
};

/// π with 113 bits, as the sum of two long doubles.
Wide pi()
{
    return Wide(3.14159265358979323851280895940618620443274267017841339111328125L) -
           Wide(5.01655761266833202355732708033075701383156167e-20L);
}

/// Cosine and sine of an angle of at most π/4.
WideVector small_direction(Wide angle)
{
    WideVector result{0, 0};
    Wide term = 1;
    for (int k = 0; k < 24; ++k) {
        const Wide sign = k / 2 % 2 == 0 ? 1 : -1;
        (k % 2 == 0 ? result.x : result.y) += sign * term;
        term = term * angle / (k + 1);
    }
    return result;
}

/// Cosine and sine of 2π i / n, i < n.
WideVector direction(std::uint64_t i, std::uint64_t n)
{
    if (8 * i <= n) return small_direction(2 * pi() * Wide(i) / Wide(n));
    if (4 * i <= n) {
        // Mirrored at the diagonal: the angle that is left to a quarter turn, as an exact fraction.
        const WideVector other = small_direction(2 * pi() * (Wide(n) - Wide(4 * i)) / Wide(4 * n));
        return {other.y, other.x};
    }
    if (2 * i <= n) {
        const WideVector other = small_direction(8 * i <= 3 * n ? 2 * pi() * (Wide(4 * i) - Wide(n)) / Wide(4 * n)
                                                                : 2 * pi() * (Wide(n) - Wide(2 * i)) / Wide(2 * n));
        return 8 * i <= 3 * n ? WideVector{-other.y, other.x} : WideVector{-other.x, other.y};
    }
    const WideVector other = direction(n - i, n);
    return {other.x, -other.y};
}

WideVector stretch(const glm::vec2& from, const glm::vec2& to)
{
    return {Wide(to.x) - Wide(from.x), Wide(to.y) - Wide(from.y)};
}
Wide length(const WideVector& v)
{
    const Wide square = v.x * v.x + v.y * v.y;
    return square > 0 ? square_root(square) : 0;
}

WideVector normal_at(std::span<const glm::vec2> profile, std::size_t j)
{
    WideVector sum{0, 0};
    for (std::size_t k = j == 0 ? 0 : j - 1; k <= j && k + 1 < profile.size(); ++k) {
        const WideVector step = stretch(profile[k], profile[k + 1]);
        const Wide size = length(step);
        if (size > 0) sum = {sum.x + step.y / size, sum.y - step.x / size};
    }
    if (profile[j].x == 0) sum.x = 0;
    const Wide size = length(sum);
    return size < Wide(1e-6) ? WideVector{0, 0} : WideVector{sum.x / size, sum.y / size};
}

glm::vec3 turned(const WideVector& v, const WideVector& towards)
{
    return {static_cast<float>(v.x * towards.x), static_cast<float>(v.y), static_cast<float>(-v.x * towards.y)};
}

}

TexturedMesh revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    if (profile.size() < 2 || copies < 4) throw std::invalid_argument("too few");
    std::vector<Wide> lengths{0};
    for (std::size_t j = 0; j < profile.size(); ++j) {
        if (!std::isfinite(profile[j].x) || !std::isfinite(profile[j].y) || profile[j].x < 0)
            throw std::invalid_argument("not a profile");
        if (j > 0) lengths.push_back(lengths.back() + length(stretch(profile[j - 1], profile[j])));
    }
    if (!(lengths.back() > 0)) throw std::invalid_argument("no length");

    TexturedMesh result;
    std::vector<WideVector> normals;
    for (std::size_t j = 0; j < profile.size(); ++j) normals.push_back(normal_at(profile, j));
    for (std::uint32_t i = 0; i < copies; ++i) {
        const WideVector towards = i + 1 == copies ? WideVector{1, 0} : direction(i, copies - 1);
        for (std::size_t j = 0; j < profile.size(); ++j) {
            result.mesh.positions.push_back(turned({profile[j].x, profile[j].y}, towards));
            result.normals.push_back(turned(normals[j], towards));
            result.texture_coordinates.emplace_back(static_cast<float>(Wide(i) / Wide(copies - 1)),
                                                    static_cast<float>(lengths[j] / lengths.back()));
        }
    }
    const auto count = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t a = 0; a + count < count * copies; ++a) {
        const std::uint32_t j = a % count;
        if (j + 1 == count || profile[j] == profile[j + 1]) continue;
        if (profile[j].x > 0) result.mesh.triangles.emplace_back(a, a + count, a + count + 1);
        if (profile[j + 1].x > 0) result.mesh.triangles.emplace_back(a, a + count + 1, a + 1);
    }
    return result;
}

}
