#include "inputs.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "row.hpp"

namespace stability {
namespace {

std::size_t size_of(char letter)
{
    switch (letter) {
        case 'f': return 1;
        case 'u': return 2;
        case 'v': return 3;
        case 'w': return 4;
        case 'm': return 9;
        case 'M': return 16;
        default: return 0;
    }
}

void draw_vector(std::vector<float>& x, std::size_t size, umbral::Random& random)
{
    const std::size_t before = x.size();
    const bool alone = before < size || random.below(2) == 0;
    const float magnitude = between_powers(random, -8, 8);
    for (std::size_t i = 0; i < size; ++i) x.push_back(random.uniform(-1, 1) * magnitude);
    if (alone) {
        if (random.below(8) == 0)
            for (std::size_t i = 1; i < size; ++i) x[before + i] = 0;
        return;
    }
    const std::uint32_t kind = random.below(4);
    const float scale = kind == 0 ? between_powers(random, -2, 2) : 1;
    const float off = kind == 1 ? 0 : between_powers(random, -8, -1);
    float longest = 0;
    for (std::size_t i = 0; i < size; ++i) longest = std::max(longest, std::abs(x[before - size + i]));
    for (std::size_t i = 0; i < size; ++i) {
        const float near = x[before - size + i] + off * longest * random.uniform(-1, 1);
        x[before + i] = (kind == 2 ? -near : near) * scale;
    }
}

float extreme_number(umbral::Random& random)
{
    constexpr float least = std::numeric_limits<float>::denorm_min();
    const std::array<float, 14> values{0,      -0.0F, least, -least, 1e-30F, -1e-30F, 1e30F,
                                       -1e30F, 1,     -1,    0.5F,   1e-8F,  3e8F,    16777217.0F};
    return values[random.below(values.size())];
}

}

std::size_t numbers_of(const char* shape)
{
    std::size_t count = 0;
    for (const char letter : std::string_view(shape)) count += size_of(letter);
    return count;
}

std::vector<float> drawn_numbers(const char* shape, umbral::Random& random)
{
    std::vector<float> x;
    for (const char letter : std::string_view(shape)) {
        if (letter == 'm')
            for (int column = 0; column < 3; ++column) draw_vector(x, 3, random);
        else if (letter == 'M')
            for (int column = 0; column < 4; ++column) draw_vector(x, 4, random);
        else if (size_of(letter) > 0)
            draw_vector(x, size_of(letter), random);
    }
    return x;
}

std::vector<float> extreme_numbers(const char* shape, umbral::Random& random)
{
    std::vector<float> x(numbers_of(shape));
    const std::uint32_t kind = random.below(4);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = kind == 0 ? random.uniform(-1, 1) : extreme_number(random);
        if (kind == 2 && i >= 3) x[i] = x[i - 3];
        if (kind == 3 && i >= 3) x[i] = -x[i - 3];
    }
    if (kind == 0) x[random.below(static_cast<std::uint32_t>(x.size()))] = extreme_number(random);
    return x;
}

}
