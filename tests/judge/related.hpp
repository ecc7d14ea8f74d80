#pragma once

#include <cmath>

#include "judge/relation.hpp"
#include "make.hpp"

/// Laws, and recordings that have them.
namespace umbral::grader::test {

inline Check with_relation(JudgeKind kind, const Relation& relation, Tolerance tolerance = {})
{
    Check check = check_of(kind, tolerance);
    check.value = "value";
    check.relation = relation;
    return check;
}

inline Relation equal()
{
    return {"upright", "turned", {0, 0}, 1, "rotating scene and camera together must not change the picture"};
}
inline Relation moved(int x, int y)
{
    return {"upright", "", {x, y}, 1, "a window further right must show the same picture there"};
}
inline Relation times(double factor)
{
    return {"upright", "", {0, 0}, factor, "twice the light must be twice as bright"};
}

/// What one run recorded, with copies that tests may spoil.
struct Recorded {
    Tensor value;
    Tensor to;
    Tensor unlike{};

    [[nodiscard]] RelatedTensors tensors() const { return {&value, &to, unlike.cells() > 0 ? &unlike : nullptr}; }
};

inline double right(const Check& check, const Recorded& student, const Recorded& reference, std::uint64_t seed = 1)
{
    return RelationJudge(check, reference.tensors(), nullptr, seed).judge(student.tensors()).right;
}

inline constexpr Colour night{8, 10, 40, 255};

/// The two balls `dx` and `dy` pixels further; beyond the border is sky.
inline Tensor balls_moved(int dx, int dy)
{
    return repaint(scene(), [&](int x, int y) {
        const int from_x = x - dx;
        const int from_y = y - dy;
        return from_x < 0 || from_y < 0 || from_x >= 128 || from_y >= 128 ? night : pixel(scene(), from_x, from_y);
    });
}

inline Tensor mirrored()
{
    return repaint(scene(), [](int x, int y) { return pixel(scene(), 127 - x, y); });
}

inline Tensor gamma_twice(const Tensor& of)
{
    return repaint(of, [&](int x, int y) {
        Colour colour = pixel(of, x, y);
        for (glm::length_t c = 0; c < 3; ++c) colour[c] = byte(255 * std::pow(colour[c] / 255.0, 1 / 2.2));
        return colour;
    });
}

inline Recorded right_pictures() { return {scene(), scene(), mirrored()}; }

inline Tensor random_table(Random& random, std::uint32_t rows, double factor = 1, std::vector<float>* kept = nullptr)
{
    std::vector<float> values;
    for (std::uint32_t i = 0; i < rows; ++i)
        values.push_back(kept != nullptr && !kept->empty() ? static_cast<float>(factor) * (*kept)[i]
                                                           : random.uniform(1, 9));
    if (kept != nullptr && kept->empty()) *kept = values;
    return floats(values);
}

inline Tensor triangle(int primitive, int x0, int y0)
{
    std::vector<float> rows;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x <= y; ++x)
            rows.insert(rows.end(),
                        {static_cast<float>(primitive), static_cast<float>(x0 + x), static_cast<float>(y0 + y)});
    return floats(rows, 3);
}

}
