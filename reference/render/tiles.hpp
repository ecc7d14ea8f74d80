#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace umbral::render {

/// A picture cut into squares, and which triangles may cover something of each. Drawn square by square, colours and
/// depths stay in the cache, wherever on the screen the next triangle of the list lies. Based on: M. Abrash.
/// Rasterization on Larrabee. Dr. Dobb's Journal, 2009 (binning).
class Tiles {
public:
    /// Colours and depths of a tile take 128 KiB at 4 bytes each.
    static constexpr int side = 128;

    Tiles(int width, int height)
        : width_(width), height_(height), columns_((width + side - 1) / side), rows_((height + side - 1) / side)
    {
        bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    }

    /// Adds number `item` to the tiles that the box from `low` to `high`, in pixels, comes within a pixel of. NaN gives
    /// the first tile.
    void add(std::uint32_t item, glm::vec2 low, glm::vec2 high)
    {
        const int left = tile_at(low.x - 1, columns_);
        const int right = tile_at(high.x + 1, columns_);
        const int bottom = tile_at(high.y + 1, rows_);
        for (int y = tile_at(low.y - 1, rows_); y <= bottom; ++y)
            for (int x = left; x <= right; ++x) bins_[static_cast<std::size_t>(y * columns_ + x)].push_back(item);
    }

    /// Calls draw(left, top, right, bottom, item), the bounds inclusive, for each item of each tile, in the order in
    /// which they were added; forgets them all.
    template <class Draw>
    void draw_all(const Draw& draw)
    {
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < columns_; ++x) {
                std::vector<std::uint32_t>& bin = bins_[static_cast<std::size_t>(y * columns_ + x)];
                const int right = std::min((x + 1) * side, width_) - 1;
                const int bottom = std::min((y + 1) * side, height_) - 1;
                for (const std::uint32_t item : bin) draw(x * side, y * side, right, bottom, item);
                bin.clear();
            }
    }

private:
    static int tile_at(float pixel, int count)
    {
        return pixel > 0 ? static_cast<int>(std::min(pixel / side, static_cast<float>(count - 1))) : 0;
    }

    int width_, height_, columns_, rows_;
    std::vector<std::vector<std::uint32_t>> bins_;
};

}
