#include "render/rays/shutter.hpp"

#include <algorithm>

#include "scene/motion.hpp"

namespace umbral::render::rays {
namespace {

constexpr int most_moments = 64;

void add(const Frame& part, float share, Frame& sum)
{
    for (std::size_t i = 0; i < sum.color.cells.size(); ++i) sum.color.cells[i] += share * part.color.cells[i];
}

}

bool is_blurred_by_motion(const scene::Scene& scene) { return scene.camera.shutter_seconds > 0 && scene::moves(scene); }

Frame draw_with_open_shutter(const scene::Scene& scene, double seconds, int width, int height, const Effort& effort,
                             RayCounts* counts)
{
    const int moments = is_blurred_by_motion(scene) ? std::clamp(effort.rays, 1, most_moments) : 1;
    std::optional<Frame> sum;
    int first = 0;
    for (int i = 0; i < moments; ++i) {
        // A single moment is the one at which the shutter opens.
        const double share = moments == 1 ? 0 : (i + 0.5) / moments;
        const scene::Scene still = scene::at_time(scene, seconds + share * scene.camera.shutter_seconds);
        const DrawList list = make_draw_list(still, width, height, true);
        Effort part = effort;
        part.first = effort.first + first;
        part.rays = static_cast<int>(static_cast<long>(effort.rays) * (i + 1) / moments) - first;
        first += part.rays;
        if (effort.progress) part.progress = [&, i](double done) { effort.progress((i + done) / moments); };
        Frame frame = draw_by_rays(list, width, height, part, counts);
        if (moments == 1) return frame;
        const float weight = static_cast<float>(part.rays) / static_cast<float>(effort.rays);
        if (!sum) {
            sum.emplace(std::move(frame));
            for (glm::vec4& color : sum->color.cells) color *= weight;
        } else {
            add(frame, weight, *sum);
        }
    }
    return std::move(*sum);
}

}
