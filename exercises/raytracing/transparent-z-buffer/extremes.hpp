#pragma once

#include "crowds.hpp"

/// Small frames of raytracing/transparent-z-buffer with one kind of rare fragments each.
namespace umbral::raytracing {

/// What is rare about the fragments: their light, how much they let through, or their depths.
enum class Rare { bright, dark, faint, opaque, negative, zero };

inline constexpr std::array rare_kinds = {Rare::bright, Rare::dark,     Rare::faint,
                                          Rare::opaque, Rare::negative, Rare::zero};

/// A number of any size between 10^low and 10^high.
inline float of_any_size(Random& random, float low, float high) { return std::pow(10.0F, random.uniform(low, high)); }

/// Light of a kind: from a hundred to ten million, or down to a millionth of a millionth.
inline glm::vec3 rare_light(Random& random, Rare kind)
{
    const glm::vec3 light = glm::vec3(0.5F) + random_light(random, 0.5F);
    if (kind == Rare::bright) return of_any_size(random, 2.5F, 7) * light;
    if (kind == Rare::dark) return of_any_size(random, -12, -6.5F) * light;
    return light;
}

/// Depths of a kind: below zero, endless among them; zero with both signs; or of few steps from 0 to 1.
inline float rare_depth(Random& random, Rare kind)
{
    const std::uint32_t step = random.below(8);
    if (kind == Rare::zero) return step < 4 ? 0.0F : -0.0F;
    if (kind != Rare::negative) return 0.125F * static_cast<float>(step);
    if (step == 0) return -std::numeric_limits<float>::infinity();
    return -of_any_size(random, -3, 3);
}

/// A row of pixels with a few fragments each, two thirds of which the pixel's depth does not hide; every fourth pixel
/// is empty before.
inline GlassTask rare_task(Random& random, Rare kind)
{
    const int width = 4;
    GlassTask task{{Grid<glm::vec3>(width, 1), Grid<float>(width, 1)}};
    for (int x = 0; x < width; ++x) {
        task.frame.light.at(x, 0) = rare_light(random, kind);
        const bool is_deep = kind == Rare::zero ? random.below(3) != 0 : kind != Rare::negative;
        const float depth = is_deep ? random.uniform(0.5F, 1) : rare_depth(random, kind);
        task.frame.depths.at(x, 0) = x == 3 ? std::numeric_limits<float>::infinity() : depth;
        // Light behind what hardly lets it through, bright enough to be seen there.
        if (kind == Rare::faint) task.frame.light.at(x, 0) *= 100.0F;
    }
    for (int i = 0; i < 4 * width; ++i) {
        GlassFragment fragment;
        fragment.pixel = {i % width, 0};
        fragment.depth = rare_depth(random, kind);
        fragment.light = rare_light(random, kind);
        fragment.k_t = random.uniform(0.2F, 1);
        if (kind == Rare::faint && random.below(2) == 0) fragment.k_t = of_any_size(random, -5, -3);
        if (kind == Rare::opaque && random.below(3) == 0) fragment.k_t = 0;
        fragment.m_t = glm::vec3(1) - random_light(random, 0.75F);
        task.glass.push_back(fragment);
        task.opaque.push_back({fragment.pixel, fragment.depth, fragment.light});
    }
    return task;
}

/// One pixel and two or three fragments in front of it, the depth of one of which is no number: the others decide.
inline GlassTask nan_task(Random& random)
{
    GlassTask task{{Grid<glm::vec3>(1, 1, random_light(random, 1)), Grid<float>(1, 1, 1.0F)}};
    const std::uint32_t count = 2 + random.below(2);
    const std::uint32_t which = random.below(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        GlassFragment fragment;
        const float depth = random.uniform(0.125F, 0.875F);
        fragment.depth = i == which ? std::numeric_limits<float>::quiet_NaN() : depth;
        fragment.light = random_light(random, 1);
        fragment.k_t = random.uniform(0.25F, 0.75F);
        fragment.m_t = glm::vec3(1) - random_light(random, 0.5F);
        task.glass.push_back(fragment);
        task.opaque.push_back({fragment.pixel, fragment.depth, fragment.light});
    }
    return task;
}

}
