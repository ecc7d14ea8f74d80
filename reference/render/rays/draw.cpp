#include "render/rays/draw.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "render/rays/light.hpp"

namespace umbral::render::rays {
namespace {

constexpr int most_side = 16384;

/// One picture; its rows are drawn by whoever asks for the next.
class Painter {
public:
    Painter(const World& world, const Effort& effort, Frame& frame)
        : world_(world), effort_(effort), frame_(frame), lens_radius_(world.list->camera.lens_radius)
    {
        if (effort.local_only)
            lens_radius_ = 0;
        else
            reach_ = {world.list->depth, world.list->bounces, true, true};
        const glm::mat4& projection = world.list->projection;
        slope_ = {1 / projection[0][0], 1 / projection[1][1]};
    }

    void draw_rows(std::atomic<int>& next, std::exception_ptr& fault, bool tells)
    {
        try {
            for (int y = next++; y < frame_.height(); y = next++) {
                for (int x = 0; x < frame_.width(); ++x)
                    if (is_drawn(effort_.every, x, y)) draw_pixel(x, y);
                if (tells) effort_.progress(static_cast<double>(y + 1) / frame_.height());
            }
        } catch (...) {
            fault = std::current_exception();
            next = frame_.height();
        }
    }

    [[nodiscard]] const RayCounts& counts() const { return counts_; }

private:
    /// Through a place in pixels, y down. t counts depth.
    [[nodiscard]] Ray ray_through(const glm::vec2& place, const glm::vec2& lens) const
    {
        const scene::Camera& camera = world_.list->camera;
        const glm::vec2 across(2 * place.x / static_cast<float>(frame_.width()) - 1,
                               1 - 2 * place.y / static_cast<float>(frame_.height()));
        const glm::vec3 direction(across * slope_, -1);
        const glm::vec3 origin(lens_radius_ * lens, 0);
        return {origin, direction - origin / camera.focus_distance, camera.near, camera.far};
    }

    void draw_pixel(int x, int y)
    {
        const glm::vec2 corner(x, y);
        // Depth and ids are seen through the middles of pixel and lens, where no ray of the colour may go.
        const bool is_apart = lens_radius_ > 0 || effort_.spread;
        glm::vec4 sum(0);
        for (int i = 0; i < effort_.rays; ++i) {
            Samples samples(x, y, effort_.first + i, effort_.scrambling);
            glm::vec2 place = samples.next();
            const glm::vec2 lens = lens_radius_ > 0 ? on_disc(samples.next()) : glm::vec2(0);
            if (effort_.first + i == 0 && !effort_.spread) place = glm::vec2(0.5F);
            const Ray ray = ray_through(corner + place, lens);
            ++counts_.camera;
            const Arrived arrived = follow(world_, reach_, ray, samples, counts_);
            if (arrived.draw != nullptr) sum += glm::vec4(arrived.light, 1);
            if (i == 0 && !is_apart && arrived.draw != nullptr) mark(x, y, *arrived.draw, arrived.position);
        }
        if (is_apart)
            if (const auto seen = look(world_, ray_through(corner + glm::vec2(0.5F), glm::vec2(0))))
                mark(x, y, *seen->draw, seen->position);
        frame_.color.at(x, y) = sum / static_cast<float>(effort_.rays);
    }

    void mark(int x, int y, const Draw& draw, const glm::vec3& position)
    {
        const glm::vec4 clip = world_.list->projection * glm::vec4(position, 1);
        frame_.ids.at(x, y) = draw.id;
        frame_.depth.at(x, y) = 0.5F + 0.5F * clip.z / clip.w;
    }

    const World& world_;
    Effort effort_;
    Frame& frame_;
    glm::vec2 slope_{1};
    float lens_radius_;
    Reach reach_;
    RayCounts counts_;  ///< of this thread alone
};

}

bool is_drawn(int every, int x, int y)
{
    if (every <= 1) return true;
    // Coprime to `every` and near its golden section: neighbouring rows are far apart.
    int step = static_cast<int>(std::lround(0.618 * every));
    while (std::gcd(step, every) != 1) ++step;
    return (1LL * x + 1LL * step * y) % every == 0;
}

Frame draw_by_rays(const DrawList& list, int width, int height, const Effort& effort, RayCounts* counts)
{
    return draw_by_rays(make_world(list), width, height, effort, counts);
}

Frame draw_by_rays(const World& world, int width, int height, const Effort& effort, RayCounts* counts)
{
    if (width < 1 || height < 1 || width > most_side || height > most_side)
        throw std::invalid_argument(
            fmt::format("draw_by_rays: expected sides of 1 to {} pixels, got {} x {}", most_side, width, height));
    if (effort.rays < 1)
        throw std::invalid_argument(fmt::format("draw_by_rays: expected a ray or more, got {}", effort.rays));
    Frame frame(width, height);
    const auto wanted =
        effort.threads > 0 ? static_cast<unsigned>(effort.threads) : std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::exception_ptr> faults(wanted);
    std::vector<RayCounts> followed(wanted);
    std::atomic<int> next = 0;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < wanted; ++i)
            threads.emplace_back([&, i] {
                Painter painter(world, effort, frame);
                painter.draw_rows(next, faults[i], i == 0 && effort.progress);
                followed[i] = painter.counts();
            });
    }
    for (const std::exception_ptr& fault : faults)
        if (fault) std::rethrow_exception(fault);
    if (counts != nullptr)
        for (const RayCounts& one : followed) *counts += one;
    return frame;
}

}
