#include <algorithm>
#include <array>
#include <cmath>

#include "judge/statistics/stochastic.hpp"

// Cuts two results into tiles and sums their differences up.
namespace umbral::grader {
namespace {

/// The large tiles are made of small ones.
constexpr int small_side = 16;
constexpr int large_side = 64;

int number_of(int size, int side) { return std::max(1, size / side); }

/// Where `count` equal parts of `size` begin, and the end of the last.
std::vector<int> edges(int size, int count)
{
    std::vector<int> result;
    for (int i = 0; i <= count; ++i) result.push_back(static_cast<int>(static_cast<std::int64_t>(size) * i / count));
    return result;
}

TileSums sums_of(const Estimates& yours, const Estimates& expected, std::size_t plane, int left, int top, int right,
                 int bottom)
{
    TileSums sums;
    for (int y = top; y < bottom; ++y) {
        const std::size_t row = plane + static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width);
        for (std::size_t at = row + static_cast<std::size_t>(left); at < row + static_cast<std::size_t>(right); ++at) {
            const double difference = yours.values[at] - expected.values[at];
            const double square = difference * difference;
            sums.yours += std::abs(yours.values[at]);
            sums.expected += std::abs(expected.values[at]);
            sums.total += expected.values[at];
            sums.difference += difference;
            sums.squares += square;
            sums.cubes += square * difference;
            if (expected.steps.empty()) continue;
            sums.steps += expected.steps[at];
            sums.clipped += yours.values[at] >= 1 || expected.values[at] >= 1 ? 1 : 0;
        }
    }
    sums.count = static_cast<double>(right - left) * (bottom - top);
    return sums;
}

Tiling smallest(const Estimates& yours, const Estimates& expected, int channel, int side)
{
    Tiling tiling{number_of(expected.width, side), number_of(expected.height, side), {}, {}, {}};
    tiling.left = edges(expected.width, tiling.across);
    tiling.top = edges(expected.height, tiling.down);
    const std::size_t plane = static_cast<std::size_t>(channel) * static_cast<std::size_t>(expected.width) *
                              static_cast<std::size_t>(expected.height);
    for (std::size_t j = 0; j + 1 < tiling.top.size(); ++j)
        for (std::size_t i = 0; i + 1 < tiling.left.size(); ++i)
            tiling.sums.push_back(
                sums_of(yours, expected, plane, tiling.left[i], tiling.top[j], tiling.left[i + 1], tiling.top[j + 1]));
    return tiling;
}

Tiling merged(const Tiling& small, int across, int down)
{
    Tiling large{across, down, {}, {}, {}};
    const std::vector<int> columns = edges(small.across, across);
    const std::vector<int> rows = edges(small.down, down);
    for (const int column : columns) large.left.push_back(small.left[static_cast<std::size_t>(column)]);
    for (const int row : rows) large.top.push_back(small.top[static_cast<std::size_t>(row)]);
    large.sums.resize(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
    for (std::size_t j = 0, n = 0; j + 1 < rows.size(); ++j)
        for (std::size_t i = 0; i + 1 < columns.size(); ++i, ++n)
            for (int y = rows[j]; y < rows[j + 1]; ++y)
                for (int x = columns[i]; x < columns[i + 1]; ++x)
                    large.sums[n] += small.sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(small.across) +
                                                static_cast<std::size_t>(x)];
    return large;
}

}

TileSums& TileSums::operator+=(const TileSums& other)
{
    count += other.count;
    yours += other.yours;
    expected += other.expected;
    total += other.total;
    difference += other.difference;
    squares += other.squares;
    cubes += other.cubes;
    steps += other.steps;
    clipped += other.clipped;
    return *this;
}

TilePlace Tiling::place(std::size_t n) const
{
    const std::size_t column = n % static_cast<std::size_t>(across);
    const std::size_t row = n / static_cast<std::size_t>(across);
    return {left[column], top[row], left[column + 1], top[row + 1]};
}

std::vector<Tiling> tilings_of(const Estimates& yours, const Estimates& expected, int channel)
{
    if (!expected.tiled) return {smallest(yours, expected, channel, std::max(expected.width, expected.height))};
    std::vector<Tiling> tilings{smallest(yours, expected, channel, small_side)};
    tilings.push_back(
        merged(tilings.front(), number_of(expected.width, large_side), number_of(expected.height, large_side)));
    tilings.push_back(merged(tilings.front(), 1, 1));
    return tilings;
}

}
