#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

/// What is written down in drivers, varied: what Variation itself does not have.
namespace umbral {

/// The list in a random order. So a pair comes in either order: who answers the first of each pair with yes and the
/// second with no knows nothing.
template <class T>
[[nodiscard]] std::vector<T> in_random_order(Random& random, std::vector<T> list)
{
    for (std::size_t i = list.size(); i > 1; --i)
        std::swap(list[i - 1], list[random.below(static_cast<std::uint32_t>(i))]);
    return list;
}

/// The list in another order, for what is asked in turn. As written unless inputs are to vary.
template <class T>
[[nodiscard]] std::vector<T> in_random_order(Variation& vary, std::vector<T> list)
{
    Random* const random = vary.random();
    return random != nullptr ? in_random_order(*random, std::move(list)) : list;
}

/// The written number, or any of the `count` ones from `least` on if inputs are to vary.
template <class T>
[[nodiscard]] T any_instead(Variation& vary, T written, T least, std::uint32_t count)
{
    Random* const random = vary.random();
    return random != nullptr ? least + random->below(count) : written;
}

/// The plane, mirrored and turned by quarters about a point. Nothing is rounded if differences to that point are not.
struct PlaneMap {
    glm::vec2 middle{0};
    bool swaps = false;  ///< x and y
    glm::vec2 sign{1};   ///< then, of each

    [[nodiscard]] glm::vec2 place(const glm::vec2& p) const
    {
        const glm::vec2 from_middle = p - middle;
        return middle + sign * (swaps ? glm::vec2(from_middle.y, from_middle.x) : from_middle);
    }
    /// Does what turns counter-clockwise then turn clockwise?
    [[nodiscard]] bool mirrors() const { return swaps != (sign.x * sign.y < 0); }
};

/// One of the seven that move something; else none.
inline PlaneMap plane_map(Variation& vary, const glm::vec2& middle = glm::vec2(0))
{
    PlaneMap map{middle};
    if (Random* const random = vary.random()) {
        const std::uint32_t which = 1 + random->below(7);
        map.swaps = (which & 4U) != 0;
        map.sign = {(which & 1U) != 0 ? -1 : 1, (which & 2U) != 0 ? -1 : 1};
    }
    return map;
}

/// The eye elsewhere about its target, as high and as far away, by at most so many radians. Unless inputs are to vary
/// it is where it was, to the last bit.
inline glm::vec3 other_eye(Variation& vary, const glm::vec3& eye, const glm::vec3& target, float most)
{
    return vary ? target + vary.turn({0, 1, 0}, most) * (eye - target) : eye;
}

/// The colour with its channels exchanged in a circle: channel `first` of 0, 1 and 2 becomes red.
inline glm::vec3 from_channel(const glm::vec3& color, int first)
{
    return {color[first], color[(first + 1) % 3], color[(first + 2) % 3]};
}

/// A share of each channel, between `least` and `most`, to multiply colours by; 1 unless inputs are to vary.
inline glm::vec3 shares(Variation& vary, float least, float most)
{
    glm::vec3 found(1);
    if (Random* const random = vary.random())
        for (int channel = 0; channel < 3; ++channel) found[channel] = random->uniform(least, most);
    return found;
}

/// A power of two from 2^-`most` to 2^`most`; 1 unless inputs are to vary.
inline float other_unit(Variation& vary, int most) { return std::ldexp(1.0F, vary.near(0, most)); }

}
