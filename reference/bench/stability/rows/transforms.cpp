#include <algorithm>
#include <cmath>

#include "../row.hpp"

namespace stability {
namespace {

using umbral::Random;

double length(Numbers x, std::size_t at) { return std::hypot(double{x[at]}, double{x[at + 1]}, double{x[at + 2]}); }

double dot_slack(Numbers x) { return 0x1p-52 * length(x, 0) * length(x, 3); }

double gram_slack(Numbers x)
{
    const double longest = std::max({length(x, 0), length(x, 3), length(x, 6)});
    return 0x1p-52 * longest * longest;
}

double defect_slack(Numbers x) { return 0x1p-50 * (length(x, 0) + length(x, 3) + length(x, 6) + length(x, 9)); }

void turn_at_3(std::vector<float>& x, Random& random) { x[6] = random.uniform(-7, 7); }
void turn_at_0(std::vector<float>& x, Random& random) { x[3] = random.uniform(-7, 7); }

// Not within 1e-6 of opposite directions.
void not_opposite(std::vector<float>& x, Random&)
{
    const glm::dvec3 a(v_at(x, 0));
    const glm::dvec3 b(v_at(x, 3));
    if (glm::dot(a, b) < 0 && glm::length(glm::cross(a, b)) < 2e-6 * glm::length(a) * glm::length(b))
        for (std::size_t i = 3; i < 6; ++i) x[i] = -x[i];
}

// Vectors of a basis, of which the third may nearly lie in the plane of the others: down to 1e-5 of its length.
void basis(std::vector<float>& x, std::size_t at, Random& random)
{
    const float scale = between_powers(random, -3, 3);
    for (std::size_t i = 0; i < 9; ++i) {
        const float corner = i % 4 == 0 ? 1.0F : 0.0F;
        x[at + i] = scale * (corner + random.uniform(-0.3F, 0.3F));
    }
    if (random.below(2) == 0) return;
    const float thin = between_powers(random, -5, 0);
    for (std::size_t i = 0; i < 3; ++i) x[at + 6 + i] = (x[at + i] + x[at + 3 + i]) / 2 + thin * x[at + 6 + i];
}
void one_frame(std::vector<float>& x, Random& random) { basis(x, 0, random); }
void two_frames(std::vector<float>& x, Random& random)
{
    basis(x, 0, random);
    basis(x, 12, random);
}
void model_matrix(std::vector<float>& x, Random& random)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            x[static_cast<std::size_t>(column * 4 + row)] = (column == row ? 1.0F : 0.0F) + random.uniform(-0.3F, 0.3F);
    x[3] = x[7] = x[11] = 0;
    x[15] = 1;
}

// Corners within a factor of 2^20 of each other, and an area that is a float.
void corners(std::vector<float>& x, Random& random)
{
    const float scale = between_powers(random, -6, 6);
    const float thin = between_powers(random, -6, 0);
    for (std::size_t i = 0; i < 9; ++i) x[i] = random.uniform(-1, 1) * scale;
    if (random.below(2) == 0) return;
    for (std::size_t i = 0; i < 3; ++i) x[6 + i] = (x[i] + x[3 + i]) / 2 + thin * random.uniform(-1, 1) * scale;
}

Answer naive_dot(Numbers x) { return numbers(glm::dot(v_at(x, 0), v_at(x, 3))); }
Answer naive_cross(Numbers x) { return numbers(glm::cross(v_at(x, 0), v_at(x, 3))); }
Answer naive_length(Numbers x) { return numbers(std::sqrt(glm::dot(v_at(x, 0), v_at(x, 0)))); }
Answer naive_normalised(Numbers x) { return numbers(v_at(x, 0) / std::sqrt(glm::dot(v_at(x, 0), v_at(x, 0)))); }
Answer naive_angle(Numbers x)
{
    const glm::vec3 a = v_at(x, 0);
    const glm::vec3 b = v_at(x, 3);
    return numbers(std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b))));
}
Answer naive_parallel(Numbers x)
{
    const glm::vec3 b = v_at(x, 3);
    return numbers(glm::dot(v_at(x, 0), b) / glm::dot(b, b) * b);
}
Answer naive_across(Numbers x)
{
    const glm::vec3 b = v_at(x, 3);
    return numbers(v_at(x, 0) - glm::dot(v_at(x, 0), b) / glm::dot(b, b) * b);
}
Answer naive_rotation(Numbers x)
{
    const glm::vec3 v = v_at(x, 0);
    const glm::vec3 axis = glm::normalize(v_at(x, 3));
    const float c = std::cos(x[6]);
    return numbers(c * v + std::sin(x[6]) * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis);
}
Answer naive_defect(Numbers x) { return numbers(v_at(x, 9) - v_at(x, 3) - v_at(x, 6) + v_at(x, 0)); }
Answer naive_gram(Numbers x) { return numbers(glm::transpose(m_at(x, 0)) * m_at(x, 0)); }
Answer naive_inverse(Numbers x)
{
    const auto column = [&](std::size_t at, float w) { return glm::vec4(v_at(x, at), w); };
    return numbers(glm::inverse(glm::mat4(column(0, 0), column(3, 0), column(6, 0), column(9, 1))));
}
Answer naive_between(Numbers x)
{
    const auto matrix = [&](std::size_t at) {
        return glm::mat4(glm::vec4(v_at(x, at), 0), glm::vec4(v_at(x, at + 3), 0), glm::vec4(v_at(x, at + 6), 0),
                         glm::vec4(v_at(x, at + 9), 1));
    };
    return numbers(glm::inverse(matrix(12)) * matrix(0));
}
Answer naive_orientation(Numbers x)
{
    const float volume = glm::determinant(m_at(x, 0));
    return numbers(volume > 0 ? 1.0F : volume < 0 ? -1.0F : 0.0F);
}
Answer naive_normal(Numbers x)
{
    return numbers(glm::normalize(glm::transpose(glm::inverse(glm::mat3(M_at(x, 0)))) * v_at(x, 16)));
}
Answer naive_plane(Numbers x)
{
    const glm::vec3 p = v_at(x, 0);
    const glm::vec3 n = glm::normalize(v_at(x, 3));
    glm::mat4 mirror(glm::mat3(1) - 2.0F * glm::outerProduct(n, n));
    mirror[3] = glm::vec4(2 * glm::dot(p, n) * n, 1);
    return numbers(mirror);
}
Answer naive_area(Numbers x)
{
    return numbers(glm::length(glm::cross(v_at(x, 3) - v_at(x, 0), v_at(x, 6) - v_at(x, 0))) / 2);
}

}

std::vector<Row> transforms_rows()
{
    using enum Unit;
    return {
        {"transforms::dot_product", ulps, 0.5, "half an ulp and 2^-52 |a||b|", naive_dot, nullptr, dot_slack},
        {"transforms::cross_product", ulps, 1, "header: an ulp", naive_cross},
        {"transforms::length_of", ulps, 1, "header: an ulp", naive_length},
        {"transforms::normalised", ulps, 1, "a quotient of doubles, rounded once", naive_normalised},
        {"transforms::angle_between", ulps, 1, "header: an ulp", naive_angle},
        {"transforms::parallel_part", ulps_of_largest, 1, "a projection in double", naive_parallel},
        {"transforms::perpendicular_part", ulps_of_largest, 1, "header: small beside its own length", naive_across},
        {"transforms::rotate_vector", ulps_of_largest, 1, "Rodrigues' formula in double, rounded once", naive_rotation,
         turn_at_3},
        {"transforms::rotation_matrix", absolute, 1e-7, "entries up to 1, rounded once", nullptr, turn_at_0},
        {"transforms::rotation_about_point", ulps_of_largest, 0.5, "header: each entry is rounded once", nullptr,
         turn_at_3},
        {"transforms::scaling_about_point", ulps_of_largest, 0.5, "header: each entry is rounded once"},
        {"transforms::scaling_along", ulps_of_largest, 0.5, "header: each entry is rounded once"},
        {"transforms::reflection_in_line", ulps_of_largest, 0.5, "header: each entry is rounded once"},
        {"transforms::reflection_in_plane", ulps_of_largest, 0.5, "header: each entry is rounded once", naive_plane},
        {"transforms::alignment", absolute, 1e-7, "header: a rounding, 1e-6 from opposite", nullptr, not_opposite},
        {"transforms::placed_along", ulps_of_largest, 0.5, "header: each entry is rounded once"},
        {"transforms::parallelogram_defect", ulps_of_largest, 0.5, "half an ulp and 2^-50 of the images", naive_defect,
         nullptr, defect_slack},
        {"transforms::gram_matrix", ulps, 0.5, "half an ulp and 2^-52 |e_i||e_j|", naive_gram, nullptr, gram_slack},
        {"transforms::inverse_of_frame", ulps_of_largest, 0.5, "header: rounds once", naive_inverse, one_frame},
        {"transforms::between_frames", ulps_of_largest, 0.5, "header: rounds once", naive_between, two_frames},
        {"transforms::orientation", absolute, 0, "header: exact for all finite floats", naive_orientation},
        {"transforms::transformed_normal", absolute, 2e-7, "entries off by 1e-7, and one product", naive_normal,
         model_matrix},
        {"meshes::triangle_area", ulps, 1, "header: an ulp, also slivers of 1e-6", naive_area, corners},
    };
}

}
