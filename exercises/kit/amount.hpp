#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace umbral {

/// What an answer amounts to, in a few numbers that are the same for every right answer: for record_cost, where the
/// whole answer is too much to record. Whoever knows the problem's size alone cannot guess them.
class Amount {
public:
    /// How many elements there are.
    Amount& count(std::size_t number)
    {
        numbers_.push_back(static_cast<float>(number));
        return *this;
    }

    /// Whole numbers or vectors of them, in whatever order they stand.
    template <class Elements>
    Amount& in_any_order(const Elements& elements)
    {
        std::uint32_t sum = 0;
        std::size_t number = 0;
        for (const auto& element : elements) {
            sum += mixed(element);
            ++number;
        }
        count(number);
        return count(sum >> 8U);  // what a float holds exactly
    }

    /// Numbers, or vectors of two or three, where the order matters: the mean of each component, and the mean weighted
    /// by the place.
    template <class Elements>
    Amount& in_order(const Elements& elements)
    {
        glm::dvec3 mean(0);
        glm::dvec3 weighted(0);
        double place = 0;
        for (const auto& element : elements) {
            mean += wide(element);
            weighted += ++place * wide(element);
        }
        count(static_cast<std::size_t>(place));
        const double size = place > 0 ? place : 1;
        for (int i = 0; i < 3; ++i) {
            numbers_.push_back(static_cast<float>(mean[i] / size));
            numbers_.push_back(static_cast<float>(weighted[i] / (size * size)));
        }
        return *this;
    }

    operator std::vector<float>() const { return numbers_; }

private:
    [[nodiscard]] static glm::dvec3 wide(const glm::vec2& vector) { return {vector, 0}; }
    template <class Element>
    [[nodiscard]] static glm::dvec3 wide(const Element& element)
    {
        return glm::dvec3(element);
    }
    [[nodiscard]] static std::uint32_t mixed(std::uint32_t number)
    {
        // Based on: C. Wellons, Hash Prospector (the function "lowbias32").
        number = (number ^ number >> 16U) * 0x7FEB352DU;
        number = (number ^ number >> 15U) * 0x846CA68BU;
        return number ^ number >> 16U;
    }
    template <class Vector>
    [[nodiscard]] static std::uint32_t mixed(const Vector& vector)
    {
        std::uint32_t sum = 0;
        for (glm::length_t i = 0; i < Vector::length(); ++i)
            sum = mixed(sum ^ static_cast<std::uint32_t>(vector[i])) + static_cast<std::uint32_t>(i);
        return sum;
    }

    std::vector<float> numbers_;
};

}
