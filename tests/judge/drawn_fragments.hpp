#pragma once

#include <string>
#include <vector>

#include "judge/make.hpp"

namespace umbral::grader::test {

/// A fragment with one attribute.
struct Spot {
    float primitive;
    float x;
    float y;
    float value = 0;
};

inline Tensor fragments(const std::vector<Spot>& spots)
{
    std::vector<float> values;
    for (const Spot& spot : spots) values.insert(values.end(), {spot.primitive, spot.x, spot.y, spot.value});
    return floats(values, 4);
}

/// Pixels of `rows` where the character is not '.', for primitive `primitive`, the first at (left, top).
inline std::vector<Spot> drawn(float primitive, const std::vector<std::string>& rows, float left = 0, float top = 0)
{
    std::vector<Spot> spots;
    for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = 0; x < rows[y].size(); ++x)
            if (rows[y][x] != '.')
                spots.push_back({primitive, left + static_cast<float>(x), top + static_cast<float>(y), 0.5F});
    return spots;
}

inline const std::vector<std::string> triangle{"#....", "##...", "###..", "####."};

inline Judgement judged(const std::vector<Spot>& yours, const std::vector<Spot>& expected, Tolerance tolerance = {},
                        const Tensor* names = nullptr)
{
    return judge(check_of(JudgeKind{"fragments"}, tolerance), fragments(yours), fragments(expected), nullptr, names);
}

}
