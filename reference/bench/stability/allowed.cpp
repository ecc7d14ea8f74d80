#include "allowed.hpp"

#include <algorithm>
#include <cmath>

#include "row.hpp"

namespace stability {
namespace {

using List = std::vector<float>;

/// What a header asks of the arguments.
struct Condition {
    std::string_view function;  ///< of a call
    bool (*holds)(const List& x) = nullptr;
    void (*prepare)(List& x) = nullptr;  ///< before that
};

bool null_at(const List& x, std::size_t at) { return v_at(x, at) == glm::vec3(0); }
// Thinner than the header of frames allows.
bool in_a_plane(const List& x, std::size_t at)
{
    const glm::dmat3 axes(m_at(x, at));
    return std::abs(glm::determinant(axes)) < 1e-6 * glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
}
bool is_a_frame(const List& x, std::size_t at)
{
    return !null_at(x, at) && !null_at(x, at + 3) && !null_at(x, at + 6) && !in_a_plane(x, at);
}
bool light_outside(const List& x)
{
    const glm::dvec3 way = glm::dvec3(v_at(x, 4)) - glm::dvec3(v_at(x, 0));
    return x[3] > 0 && glm::length(way) > 1.001 * x[3];
}
// Of a unit normal: the slopes for which the header announces no NaN, tangents that are not nearly parallel, and a
// normal that is not nearly in their plane.
bool can_be_bumped(const List& x)
{
    const glm::dvec3 u(v_at(x, 3));
    const glm::dvec3 v(v_at(x, 6));
    return std::abs(x[9]) <= 1e6 * glm::length(u) && std::abs(x[10]) <= 1e6 * glm::length(v) &&
           std::abs(glm::dot(glm::cross(u, v), glm::dvec3(v_at(x, 0)))) >= 1e-3 * glm::length(u) * glm::length(v);
}
bool exponent_allowed(const List& x) { return x[9] >= 0 && x[9] <= 1e4F; }
void make_two_units(List& x)
{
    make_unit(x, 0);
    make_unit(x, 3);
}
void put_matrix(List& x, const glm::mat3& matrix)
{
    for (int entry = 0; entry < 9; ++entry) x[static_cast<std::size_t>(entry)] = matrix[entry / 3][entry % 3];
}
void make_gram(List& x) { put_matrix(x, glm::transpose(m_at(x, 0)) * m_at(x, 0)); }
void make_symmetric(List& x)
{
    x[3] = x[1];
    x[6] = x[2];
    x[7] = x[5];
}
// No eigenvalue is a thousand times another.
bool is_round(const glm::dmat3& gram)
{
    const double trace = gram[0][0] + gram[1][1] + gram[2][2];
    return std::isfinite(trace) && glm::determinant(gram) > 1e-3 * trace * trace * trace;
}
bool has_round_gram(const List& x)
{
    const glm::dmat3 basis(m_at(x, 0));
    return is_round(glm::transpose(basis) * basis);
}
bool within(const List& x, float least, float largest)
{
    return std::ranges::all_of(
        x, [&](float one) { return one == 0 || (std::abs(one) >= least && std::abs(one) <= largest); });
}
// Small enough for a sum of products of two, or of three.
bool products_fit(const List& x) { return within(x, 0, 1e18F); }
bool threefold_products_fit(const List& x) { return within(x, 0, 1e12F); }
bool lengths_fit(const List& x) { return within(x, 1e-15F, 1e15F); }
// A plane that does not lie farther away than any float.
bool is_plane(const List& x, std::size_t at)
{
    return !null_at(x, at) && std::abs(x[at + 3]) <= 1e18 * glm::length(glm::dvec3(v_at(x, at)));
}
bool is_seen_clearly(const List& x)
{
    const glm::dmat4 rows = glm::transpose(glm::dmat4(M_at(x, 0)));
    const glm::dvec4 terms = rows[3] * glm::dvec4(v_at(x, 16), 1);
    const double w = terms.x + terms.y + terms.z + terms.w;
    return lengths_fit(x) && std::abs(w) >= 1e-6 &&
           std::abs(w) >= 1e-9 * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
}

// Where a function is not named, its header asks nothing that could be broken, or it throws.
constexpr Condition conditions[] = {
    {"transforms::inverse_of_frame", [](const List& x) { return is_a_frame(x, 0); }},
    {"transforms::between_frames", [](const List& x) { return is_a_frame(x, 12) && lengths_fit(x); }},
    {"transforms::transform_point", products_fit},
    {"transforms::transform_vector", products_fit},
    {"transforms::across", products_fit},
    {"transforms::dot_from_gram", threefold_products_fit, make_symmetric},
    {"transforms::area_from_gram",
     [](const List& x) { return is_round(glm::dmat3(m_at(x, 0))) && threefold_products_fit(x); }, make_gram},
    {"transforms::cross_in_basis", [](const List& x) { return has_round_gram(x) && threefold_products_fit(x); }},
    {"projections::project_point", is_seen_clearly},
    {"interaction::rolling_turn", [](const List& x) { return x[2] > 0; }},
    {"lighting::blinn_highlight", exponent_allowed},
    {"lighting::phong_highlight", exponent_allowed},
    {"lighting::brightest_diffuse", light_outside},
    {"raytracing::mirrored_direction", nullptr, make_two_units},
    {"raytracing::refracted_direction", [](const List& x) { return x[6] > 0 && x[7] > 0; }, make_two_units},
    {"raytracing::cosine_density", nullptr, make_two_units},
    {"raytracing::critical_angle", [](const List& x) { return x[0] > 0 && x[1] > 0; }},
    {"raytracing::mirror_matrix", [](const List& x) { return is_plane(x, 0); }},
    {"raytracing::mirrored_view", [](const List& x) { return is_plane(x, 16) && threefold_products_fit(x); }},
    {"raytracing::sdf::ball_distance", lengths_fit},
    {"raytracing::sdf::box_distance", lengths_fit},
    {"raytracing::sdf::torus_distance", lengths_fit},
    {"raytracing::sdf::capsule_distance", lengths_fit},
    {"texturing::box_place", [](const List& x) { return !null_at(x, 0); }},
    {"texturing::panorama_place", [](const List& x) { return !null_at(x, 0); }},
    {"texturing::sphere_place", [](const List& x) { return !null_at(x, 0); }},
    {"texturing::bumped_normal", can_be_bumped, [](List& x) { make_unit(x, 0); }},
    {"texturing::level_at_distance", [](const List& x) { return x[0] > 0 && x[1] > 0; }},
};

}

std::optional<std::vector<float>> allowed(std::string_view function, std::vector<float> question)
{
    const auto* const found =
        std::ranges::find_if(conditions, [&](const Condition& one) { return one.function == function; });
    if (found == std::end(conditions)) return question;
    if (found->prepare != nullptr) found->prepare(question);
    if (found->holds != nullptr && !found->holds(question)) return std::nullopt;
    return question;
}

}
