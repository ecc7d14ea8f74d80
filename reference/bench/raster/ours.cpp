#include <algorithm>
#include <memory>

#include "raster.hpp"
#include "render/raster.hpp"
#include "render/tiles.hpp"
#include "render/vertex_stage.hpp"

namespace umbral::bench {
namespace {

using namespace umbral::render;

/// Eight bits a channel, from 0 to 1, rounded.
struct Gouraud {
    glm::vec3 last, first_less_last, second_less_last;
    std::uint32_t* pixels;

    [[gnu::always_inline]] void operator()(const Passed& passed) const
    {
        IntLanes packed = {};
        for (int i = 2; i >= 0; --i) {
            const FloatLanes channel =
                last[i] + first_less_last[i] * passed.weights[0] + second_less_last[i] * passed.weights[1];
            packed = (packed << 8) | __builtin_convertvector(channel, IntLanes);
        }
        store(pixels + passed.at, passed.mask, packed);
    }
};

class Ours final : public RasterContestant {
public:
    Ours(std::span<const RasterVertex> vertices, int side)
        : vertices_(vertices),
          side_(side),
          cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)),
          depths_(cells_ + lane_count),
          pixels_(cells_ + lane_count),
          tiles_(side, side)
    {
    }

    void clear() override
    {
        std::fill(depths_.begin(), depths_.end(), 1.0F);
        std::fill(pixels_.begin(), pixels_.end(), 0U);
    }

    // As software.cpp: vertices to the window, triangles to the tiles, then tile by tile.
    void draw() override
    {
        clear();
        placed_.clear();
        for (const RasterVertex& vertex : vertices_) placed_.push_back(to_window(vertex.clip, side_, side_));
        for (std::size_t i = 0; i + 2 < placed_.size(); i += 3) {
            const glm::vec2& a = placed_[i].position;
            const glm::vec2& b = placed_[i + 1].position;
            const glm::vec2& c = placed_[i + 2].position;
            tiles_.add(static_cast<std::uint32_t>(i), glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)));
        }
        tiles_.draw_all([&](int left, int top, int right, int bottom, std::size_t i) {
            const glm::vec3& c = vertices_[i + 2].color;
            const Gouraud shader{255.0F * c + 0.5F, 255.0F * (vertices_[i].color - c),
                                 255.0F * (vertices_[i + 1].color - c), pixels_.data()};
            draw_triangle(
                {placed_[i], placed_[i + 1], placed_[i + 2]}, {{left, right}, {top, bottom}}, side_, depths_.data(),
                [](int) {}, shader);
        });
    }

    [[nodiscard]] Grid<std::uint32_t> picture() const override
    {
        Grid<std::uint32_t> grid(side_, side_);
        std::copy_n(pixels_.begin(), cells_, grid.cells.begin());
        return grid;
    }

private:
    std::span<const RasterVertex> vertices_;
    int side_;
    std::size_t cells_;
    std::vector<float> depths_;
    std::vector<std::uint32_t> pixels_;
    std::vector<pipeline::WindowVertex> placed_;
    Tiles tiles_;
};

}

std::unique_ptr<RasterContestant> make_our_raster(std::span<const RasterVertex> vertices, int side)
{
    return std::make_unique<Ours>(vertices, side);
}

}
