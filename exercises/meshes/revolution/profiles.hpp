#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <kit/profiles.hpp>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <vector>

/// Profiles to turn: of known things, of any shape, long ones, and bad ones.
namespace umbral::meshes {

using profiles::Profile;

/// A ball from pole to pole.
inline Profile semicircle(int points)
{
    Profile profile;
    for (int j = 0; j < points; ++j) {
        const double angle = 3.141592653589793 * (static_cast<double>(j) / (points - 1) - 0.5);
        const bool is_pole = j == 0 || j == points - 1;
        profile.emplace_back(is_pole ? 0.0 : std::cos(angle), std::sin(angle));
    }
    return profile;
}

/// Any profile that goes up and down, in and out; some points lie on the axis or just beside it, some stand twice or
/// three times or have a neighbour so near that both have the same t, and one profile in four ends where it began.
inline Profile some_profile(Random& random)
{
    Profile profile{{random.uniform(0.5F, 2), random.uniform(-1, 1)}};
    for (std::uint32_t left = 2 + random.below(7); left > 0; --left) {
        const glm::vec2 step(random.uniform(-1.5F, 1.5F), random.uniform(-0.5F, 1.5F));
        const std::uint32_t kind = random.below(8);
        glm::vec2 next(std::abs(profile.back().x + step.x) + 0.125F, profile.back().y + step.y);
        if (kind == 0) next = profile.back();
        if (kind == 0 && random.below(2) == 0) profile.push_back(next);
        if (kind == 1) next.x = 0;
        if (kind == 2) next.x = 0x1p-15F * random.uniform(0.5F, 1);
        // By two floats: so far that they do not become one point when they are turned.
        if (kind >= 6 && profile.back().x > 0)
            next = {std::nextafter(std::nextafter(profile.back().x, 4.0F), 4.0F), profile.back().y};
        profile.push_back(next);
    }
    profile.emplace_back(1.5F, profile.back().y + 1);
    if (random.below(4) == 0) profile.push_back(profile.front());
    return profile;
}

/// A long profile of very many points: a wavy column. The steps are all alike in size, a few percent.
inline Profile long_profile(std::uint32_t points, Random& random)
{
    Profile profile;
    const float height = 1000.0F / static_cast<float>(points);
    for (std::uint32_t j = 0; j < points; ++j) {
        const float up = static_cast<float>(j) * height;
        profile.emplace_back(3 + std::sin(0.05F * up), up + 0.3F * height * random.uniform());
    }
    return profile;
}

/// A vase, thin, with an inside.
inline Profile vase()
{
    Profile profile{{0, 0}, {0.45F, 0}, {0.45F, 0}};
    const auto radius = [](double up) { return 0.45 + 0.32 * std::sin(3.4 * up) * (1 - 0.35 * up) - 0.12 * up; };
    for (int k = 1; k <= 24; ++k) profile.emplace_back(radius(1.7 * k / 24 / 1.2), 1.7 * k / 24);
    profile.push_back(profile.back());
    profile.push_back(profile.back() - glm::vec2(0.06F, 0));
    profile.push_back(profile.back());
    for (int k = 23; k >= 2; --k) profile.emplace_back(radius(1.7 * k / 24 / 1.2) - 0.06, 1.7 * k / 24);
    return profile;
}

/// What cannot be turned, or hardly: a profile and a number of copies.
struct Attempt {
    Profile profile;
    std::uint32_t copies;
};

/// In pairs: the first can be turned, the second cannot.
inline std::vector<Attempt> attempts()
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    return {{{{1, 0}, {1, 1}}, 4},         {{{1, 0}, {1, 1}}, 3},
            {{{1, 0}, {1, 0}, {1, 1}}, 5}, {{{1, 0}, {1, 0}, {1, 0}}, 5},
            {{{0, 0}, {0, 1}, {1, 1}}, 5}, {{{0, 0}, {-1, 1}, {1, 1}}, 5},
            {{{1, 0}, {1e-30F, 1}}, 5},    {{{1, 0}, {-1e-30F, 1}}, 5},
            {{{1, 0}, {1, 1e30F}}, 5},     {{{1, 0}, {1, infinity}}, 5},
            {{{2, 0}, {1, 0}}, 6},         {{{2, 0}, {not_a_number, 0}}, 6},
            {{{1, 0}, {1, 1}}, 6},         {{{1, 0}}, 6},
            {{{3, 0}, {3, 1}}, 7},         {{}, 7},
            {{{3, 0}, {3, 1}}, 8},         {{{3, 0}, {3, 1}}, 1},
            {{{3, 0}, {3, 1}}, 9},         {{{3, 0}, {3, 1}}, 0},
            {{{1, 0}, {1e30F, 1}}, 5},     {{{1, 0}, {infinity, 1}}, 5},
            {{{1, 0}, {1, -1e30F}}, 5},    {{{1, 0}, {1, -infinity}}, 5},
            {{{2, 0}, {1, 1}}, 6},         {{{2, 0}, {1, not_a_number}}, 6},
            {{{-0.0F, 0}, {1, 1}}, 5},     {{{-1e-44F, 0}, {1, 1}}, 5},
            {{{0, 0}, {0, 2}}, 5},         {{{0, 2}, {0, 2}}, 5},
            {{{1, 0}, {2, 1}, {1, 0}}, 5}, {{}, 5},
            {{{1, 0}, {1, 1e-30F}}, 5},    {{{1, 1e-30F}, {1, 1e-30F}}, 5}};
}

/// The pairs, each begun with either; in another order if inputs are to vary.
inline std::vector<Attempt> varied(Random& random, Variation& vary, const std::vector<Attempt>& all)
{
    std::vector<std::vector<Attempt>> pairs;
    for (std::size_t i = 0; i + 1 < all.size(); i += 2)
        pairs.push_back(in_random_order(random, std::vector{all[i], all[i + 1]}));
    std::vector<Attempt> result;
    for (const std::vector<Attempt>& pair : in_random_order(vary, pairs))
        result.insert(result.end(), pair.begin(), pair.end());
    return result;
}

}
