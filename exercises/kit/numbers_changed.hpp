#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <tuple>
#include <umbral/core/random.hpp>
#include <umbral/record/call_text.hpp>
#include <umbral/record/literal.hpp>
#include <umbral/record/reflect.hpp>
#include <utility>
#include <vector>

#include "varied.hpp"

/// Questions that follow from another one by a change of single numbers: for what random numbers never are.
namespace umbral {
namespace detail {

/// A number of a question, and one that stands beside it in the same vector; null for a number of its own.
struct NumberPlace {
    float* number = nullptr;
    const float* beside = nullptr;
};

inline void add_numbers(float& number, std::vector<NumberPlace>& places) { places.push_back({&number, nullptr}); }

template <glm::length_t L>
void add_numbers(glm::vec<L, float>& vector, std::vector<NumberPlace>& places)
{
    for (glm::length_t i = 0; i < L; ++i) places.push_back({&vector[i], &vector[(i + 1) % L]});
}

/// The floats in structs, lists and tuples. Not of matrices, which are seldom valid with one number changed.
template <class Value>
void add_numbers(Value& value, std::vector<NumberPlace>& places)
{
    if constexpr (GrowingList<Value>)
        for (auto& element : value) add_numbers(element, places);
    else if constexpr (requires { std::tuple_size<Value>::value; })
        std::apply([&](auto&... each) { (add_numbers(each, places), ...); }, value);
    else if constexpr (reflect::is_plain_struct<Value> && !literal::detail::is_matrix<Value>)
        reflect::for_each_field(value, [&](std::string_view /*name*/, auto& field) { add_numbers(field, places); });
}

/// Never the number's sign, so that what must not be negative stays so, unless that beside it has another.
inline float changed_number(Random& random, const NumberPlace& place, std::uint32_t way)
{
    const float number = *place.number;
    switch (way % 4) {
        case 0: return 0;
        case 1: return number / (1 + std::abs(number)) * random.uniform(0.2F, 1);
        case 2: return place.beside != nullptr ? *place.beside : number * random.uniform(1.25F, 2);
        default: return number * random.uniform(0.5F, 2);
    }
}

}

/// The question, followed by up to `most` others, each as the one before but for one number: that is 0 now, nearer to 0
/// than 1, the same as another coordinate of its vector, or up to twice as large or small. So whoever takes two numbers
/// for one, thinks that none is 0 or below 1, or remembers an answer too long, is asked about it. The numbers are those
/// of the question's fields (a plain struct or tuple, and the structs, lists and vectors in it, but no matrices), each
/// changed once at most, in a random order. `allowed` says of a question whether the statement allows it; changes that
/// it refuses are not made.
template <class Question, class Allowed>
[[nodiscard]] std::vector<Question> numbers_changed(Random& random, Question question, std::size_t most,
                                                    const Allowed& allowed)
{
    std::vector<Question> all{question};
    std::vector<detail::NumberPlace> places;
    detail::add_numbers(question, places);
    for (const detail::NumberPlace& place : in_random_order(random, places)) {
        if (all.size() > most) break;
        const float before = *place.number;
        const std::uint32_t first = random.below(4);
        for (std::uint32_t way = first; way < first + 4; ++way) {
            *place.number = detail::changed_number(random, place, way);
            if (*place.number != before && allowed(std::as_const(question))) {
                all.push_back(question);
                break;
            }
            *place.number = before;
        }
    }
    return all;
}

/// The same where the statement allows any numbers.
template <class Question>
[[nodiscard]] std::vector<Question> numbers_changed(Random& random, const Question& question, std::size_t most)
{
    return numbers_changed(random, question, most, [](const Question& /*any*/) { return true; });
}

}
