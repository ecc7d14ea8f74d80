#pragma once

#include "judge/picture/image_rule.hpp"
#include "make.hpp"

namespace umbral::grader::test {

inline Judgement image(const Tensor& student, const Tensor& expected)
{
    return judge(check_of(JudgeKind{"image"}), student, expected, nullptr);
}

inline ImageRule rule(const Tensor& student, const Tensor& expected)
{
    const Check check = check_of(JudgeKind{"image"});
    return apply_image_rule(to_picture(check, student), to_picture(check, expected));
}

/// Of balls().
inline bool background(const Colour& colour) { return colour == Colour{8, 10, 40, 255}; }

inline Colour moved(Colour colour, int by)
{
    for (glm::length_t c = 0; c < 3; ++c) colour[c] = byte(colour[c] + by);
    return colour;
}

}
