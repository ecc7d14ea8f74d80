#pragma once

#include <cmath>
#include <kit/numbers_changed.hpp>
#include <tuple>
#include <umbral/record/ask.hpp>
#include <umbral/transforms/about_a_point.hpp>

#include "../support.hpp"

namespace umbral::transforms {

inline bool is_near(const glm::vec3& v, float most)
{
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
}

using Placed = std::tuple<glm::vec3, glm::vec3>;

inline void record_changed_directions(Random& random, Recorder& out, const Placed& placed)
{
    const auto near = [](const auto& question) { return is_near(std::get<0>(question), 8); };
    for (const auto& [point, direction] : numbers_changed(random, placed, 6, near))
        out.append("line", ask<reflection_in_line>(out, point, direction));
    for (const auto& [point, normal] : numbers_changed(random, placed, 6, near))
        out.append("plane", ask<reflection_in_plane>(out, point, normal));
    // Along the vertical, or clearly aside of it: the tolerance is for such ones.
    const auto has_aside = [&](const Placed& question) {
        const glm::vec3& direction = std::get<1>(question);
        const float aside = std::hypot(direction.x, direction.z);
        return near(question) && (aside == 0 || aside > 0.1F * length(direction));
    };
    for (const auto& [position, direction] : numbers_changed(random, placed, 6, has_aside))
        out.append("placed", ask<placed_along>(out, position, direction));
    const glm::vec3 from = std::get<1>(placed);
    const glm::vec3 aside = length(from) * normalize(cross(from, random.unit_vector()));
    const float angle = random.uniform(0.4F, 2.7F);
    const Placed aligned(from, std::cos(angle) * from + std::sin(angle) * aside);
    const auto is_clear = [](const Placed& question) {
        const auto& [one, other] = question;
        return std::abs(dot(one, other)) < 0.95F * length(one) * length(other);
    };
    for (const auto& [one, other] : numbers_changed(random, aligned, 6, is_clear))
        out.append("alignment", ask<alignment>(out, one, other));
}

/// Chains of questions in which one number changes, so that coordinates, factors and angles are 0, or equal, and one
/// argument changes alone. No number becomes larger than random ones are: that is what the tolerances are for.
inline void record_changed(Random& random, Recorder& out)
{
    const auto allowed = [](const auto& question) { return is_near(std::get<0>(question), 8); };
    const glm::vec3 centre = 8.0F * random.in_cube();
    const glm::vec3 direction = random.uniform(0.5F, 4) * random.unit_vector();
    for (const auto& [about, turn] : numbers_changed(random, std::tuple(centre, random_turn(random)), 7, allowed))
        out.append("rotation", ask<rotation_about_point>(out, about, turn));
    const auto has_factors = [&](const Placed& question) {
        return allowed(question) && is_near(std::get<1>(question), 5);
    };
    const Placed scaled(centre, 5.0F * random.in_cube());
    for (const auto& [about, factors] : numbers_changed(random, scaled, 6, has_factors))
        out.append("scaling", ask<scaling_about_point>(out, about, factors));
    const auto has_factor = [&](const auto& question) {
        return allowed(question) && std::abs(std::get<2>(question)) <= 4;
    };
    const std::tuple along(centre, direction, random.uniform(-4, 4));
    for (const auto& [point, axis, factor] : numbers_changed(random, along, 7, has_factor))
        out.append("along", ask<scaling_along>(out, point, axis, factor));
    for (const auto& [middle] : numbers_changed(random, std::tuple(centre), 3, allowed))
        out.append("point", ask<reflection_in_point>(out, middle));
    record_changed_directions(random, out, {centre, direction});
}

}
