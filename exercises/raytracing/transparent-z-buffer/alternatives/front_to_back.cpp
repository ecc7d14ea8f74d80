// alternative: from the nearest to the farthest, with what each sum still gets through; in double, pixel by pixel
#include <algorithm>
#include <limits>
#include <map>
#include <umbral/raytracing/transparent_z_buffer.hpp>

namespace umbral::raytracing {

GlassFrame empty_glass_frame(int width, int height, const glm::vec3& background)
{
    GlassFrame frame;
    frame.light = Grid<glm::vec3>(width, height);
    frame.depths = Grid<float>(width, height);
    std::fill(frame.light.cells.begin(), frame.light.cells.end(), background);
    std::fill(frame.depths.cells.begin(), frame.depths.cells.end(), std::numeric_limits<float>::infinity());
    return frame;
}

void draw_opaque(GlassFrame& frame, const std::vector<OpaqueFragment>& fragments)
{
    for (const auto& [pixel, depth, light] : fragments) {
        if (pixel.x < 0 || pixel.x >= frame.light.width || pixel.y < 0 || pixel.y >= frame.light.height) continue;
        float& z = frame.depths.at(pixel.x, pixel.y);
        if (z > depth) {
            z = depth;
            frame.light.at(pixel.x, pixel.y) = light;
        }
    }
}

void filter_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    for (auto fragment = fragments.rbegin(); fragment != fragments.rend(); ++fragment) {
        const auto [x, y] = std::pair(fragment->pixel.x, fragment->pixel.y);
        if (!frame.light.contains(x, y) || !(frame.depths.at(x, y) > fragment->depth)) continue;
        for (int channel = 0; channel < 3; ++channel) {
            frame.light.at(x, y)[channel] *= fragment->m_t[channel];
            frame.light.at(x, y)[channel] *= fragment->k_t;
        }
    }
}

void blend_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    std::map<std::pair<int, int>, std::vector<std::size_t>> pixels;
    for (std::size_t i = 0; i < fragments.size(); ++i)
        pixels[{fragments[i].pixel.x, fragments[i].pixel.y}].push_back(i);
    for (auto& [place, list] : pixels) {
        if (!frame.light.contains(place.first, place.second)) continue;
        const float z = frame.depths.at(place.first, place.second);
        std::erase_if(list, [&](std::size_t i) { return !(fragments[i].depth < z); });
        std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
            return fragments[a].depth != fragments[b].depth ? fragments[a].depth < fragments[b].depth : a > b;
        });
        glm::dvec3 sum(0);
        glm::dvec3 through(1);
        for (const std::size_t i : list) {
            sum += through * glm::dvec3(fragments[i].light);
            through *= double{fragments[i].k_t} * glm::dvec3(fragments[i].m_t);
        }
        glm::vec3& light = frame.light.at(place.first, place.second);
        light = glm::vec3(sum + through * glm::dvec3(light));
    }
}

}
