#include "bench/explanations/disturb.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

bool is_grid(const Tensor& tensor) { return tensor.columns > 1 && tensor.rows > 1; }

struct Range {
    double low = 0;
    double high = 1;
};

Range range_of(const std::vector<double>& values)
{
    Range range{INFINITY, -INFINITY};
    for (const double value : values)
        if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
    if (!(range.low < range.high)) return {range.low - 1, range.low + 1};
    return range;
}

using Change = std::function<void(std::vector<double>& values, std::size_t row, std::size_t components)>;

/// `change` for a share of the rows.
Tensor change_rows(const Tensor& right, Random& random, float share, const Change& change)
{
    std::vector<double> values = to_doubles(right);
    for (std::size_t row = 0; row < right.cells(); ++row)
        if (random.uniform(0, 1) < share) change(values, row, right.components);
    return with_values(right, values);
}

Tensor replace_rows(const Tensor& right, Random& random)
{
    const Range range = range_of(to_doubles(right));
    return change_rows(right, random, 0.3F, [&](std::vector<double>& values, std::size_t row, std::size_t components) {
        for (std::size_t c = 0; c < components; ++c)
            values[row * components + c] =
                random.uniform(static_cast<float>(range.low), static_cast<float>(range.high));
    });
}

Tensor add_noise(const Tensor& right, Random& random)
{
    const Range range = range_of(to_doubles(right));
    const double size = 0.1 * (range.high - range.low);
    return change_rows(right, random, 1, [&](std::vector<double>& values, std::size_t row, std::size_t components) {
        for (std::size_t c = 0; c < components; ++c)
            values[row * components + c] += size * (random.uniform(-1, 1) + random.uniform(-1, 1));
    });
}

// A third of the rows, or of a picture's lines, in one piece.
Tensor lose_a_part(const Tensor& right, Random& random)
{
    const std::size_t lines = is_grid(right) ? right.rows : right.cells();
    const std::size_t line = lines == 0 ? 0 : right.cells() / lines;
    const std::size_t start = random.below(static_cast<std::uint32_t>(std::max<std::size_t>(1, lines)));
    std::vector<double> values = to_doubles(right);
    for (std::size_t i = start; i < std::min(lines, start + lines / 3 + 1); ++i)
        for (std::size_t v = i * line * right.components; v < (i + 1) * line * right.components; ++v) values[v] = 0;
    return with_values(right, values);
}

Tensor mix_rows(const Tensor& right, Random& random)
{
    std::vector<double> values = to_doubles(right);
    const std::size_t cells = right.cells();
    for (std::size_t i = cells; i > 1; --i) {
        const std::size_t j = random.below(static_cast<std::uint32_t>(i));
        for (std::size_t c = 0; c < right.components; ++c)
            std::swap(values[(i - 1) * right.components + c], values[j * right.components + c]);
    }
    return with_values(right, values);
}

Tensor bend(const Tensor& right, Random& random)
{
    const Range range = range_of(to_doubles(right));
    const double size = range.high - range.low;
    const double phase = random.uniform(0, 6);
    return change_rows(right, random, 1, [&](std::vector<double>& values, std::size_t row, std::size_t components) {
        for (std::size_t c = 0; c < components; ++c) {
            double& value = values[row * components + c];
            value += 0.2 * size * std::sin(7 * (value - range.low) / size + phase + static_cast<double>(c));
        }
    });
}

Tensor flip_presence(const Tensor& right, Random& random)
{
    Tensor result = right;
    for (std::uint8_t& present : result.present)
        if (random.uniform(0, 1) < 0.2F) present = present != 0 ? 0 : 1;
    return result;
}

// Each line moved by another number of pixels.
Tensor jitter_lines(const Tensor& right, Random& random)
{
    if (!is_grid(right)) return right;
    Tensor result = right;
    const std::size_t cell = size_of(right.element) * right.components;
    for (std::size_t y = 0; y < right.rows; ++y) {
        const std::size_t by = random.below(7);
        for (std::size_t x = 0; x < right.columns; ++x)
            std::memcpy(result.bytes.data() + (y * right.columns + x) * cell,
                        right.bytes.data() + (y * right.columns + (x + by) % right.columns) * cell, cell);
    }
    return result;
}

Tensor speckle(const Tensor& right, Random& random) { return is_grid(right) ? replace_rows(right, random) : right; }

// The mean of five pixels in a line.
Tensor smear(const Tensor& right, Random&)
{
    if (!is_grid(right)) return right;
    const std::vector<double> from = to_doubles(right);
    std::vector<double> to = from;
    const std::size_t components = right.components;
    for (std::size_t cell = 2; cell + 2 < right.cells(); ++cell)
        for (std::size_t c = 0; c < components; ++c) {
            double sum = 0;
            for (std::size_t i = cell - 2; i <= cell + 2; ++i) sum += from[i * components + c];
            to[cell * components + c] = sum / 5;
        }
    return with_values(right, to);
}

constexpr std::array all{Disturbance{"rows replaced", replace_rows},
                         Disturbance{"noise", add_noise},
                         Disturbance{"a part lost", lose_a_part},
                         Disturbance{"rows mixed", mix_rows},
                         Disturbance{"values bent", bend},
                         Disturbance{"presence flipped", flip_presence},
                         Disturbance{"lines jittered", jitter_lines},
                         Disturbance{"speckled", speckle},
                         Disturbance{"smeared", smear}};

template <class Float>
void move_floats(Tensor& tensor, Random& random)
{
    for (std::size_t i = 0; i < tensor.count(); ++i) {
        Float value;
        std::memcpy(&value, tensor.bytes.data() + i * sizeof value, sizeof value);
        const std::uint32_t way = random.below(3);
        if (way == 2 || value == 0 || !std::isfinite(value)) continue;
        value = std::nextafter(
            value, way == 0 ? -std::numeric_limits<Float>::infinity() : std::numeric_limits<Float>::infinity());
        std::memcpy(tensor.bytes.data() + i * sizeof value, &value, sizeof value);
    }
}

}

std::span<const Disturbance> disturbances() { return all; }

Tensor rounded_otherwise(const Tensor& tensor, Random& random)
{
    Tensor result = tensor;
    if (tensor.element == Element::float32) move_floats<float>(result, random);
    if (tensor.element == Element::uint8 && is_grid(tensor))
        for (std::byte& byte : result.bytes)
            if (random.below(10) == 0)
                byte = static_cast<std::byte>(
                    std::clamp(std::to_integer<int>(byte) + (random.below(2) == 0 ? 1 : -1), 0, 255));
    return result;
}

}
