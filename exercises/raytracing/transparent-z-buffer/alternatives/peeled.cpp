// alternative: layer by layer, each pass the farthest fragment that is left in each pixel
#include <limits>
#include <umbral/raytracing/transparent_z_buffer.hpp>

namespace umbral::raytracing {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class Canvas {
public:
    explicit Canvas(GlassFrame& frame) : frame_(frame) {}

    bool shows(const glm::ivec2& p, float depth) const
    {
        const bool outside = p.x < 0 || p.y < 0 || p.x >= frame_.depths.width || p.y >= frame_.depths.height;
        return !outside && depth < frame_.depths.cells[index(p)];
    }
    glm::vec3& light(const glm::ivec2& p) { return frame_.light.cells[index(p)]; }
    float& depth(const glm::ivec2& p) { return frame_.depths.cells[index(p)]; }
    std::size_t index(const glm::ivec2& p) const { return static_cast<std::size_t>(p.y * frame_.depths.width + p.x); }

private:
    GlassFrame& frame_;
};

}

GlassFrame empty_glass_frame(int width, int height, const glm::vec3& background)
{
    return GlassFrame{{width, height, background}, {width, height, infinity}};
}

void draw_opaque(GlassFrame& frame, const std::vector<OpaqueFragment>& fragments)
{
    Canvas canvas(frame);
    for (const OpaqueFragment& f : fragments)
        if (canvas.shows(f.pixel, f.depth)) canvas.light(f.pixel) = f.light, canvas.depth(f.pixel) = f.depth;
}

void filter_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    Canvas canvas(frame);
    for (const GlassFragment& f : fragments)
        if (canvas.shows(f.pixel, f.depth)) canvas.light(f.pixel) = f.k_t * (f.m_t * canvas.light(f.pixel));
}

void blend_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    Canvas canvas(frame);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < fragments.size(); ++i)
        if (canvas.shows(fragments[i].pixel, fragments[i].depth)) left.push_back(i);
    while (!left.empty()) {
        std::vector<std::size_t> farthest(frame.depths.cells.size(), fragments.size());
        for (const std::size_t i : left) {
            std::size_t& best = farthest[canvas.index(fragments[i].pixel)];
            if (best == fragments.size() || fragments[i].depth > fragments[best].depth) best = i;
        }
        std::vector<std::size_t> rest;
        for (const std::size_t i : left) {
            const GlassFragment& f = fragments[i];
            if (farthest[canvas.index(f.pixel)] == i)
                canvas.light(f.pixel) = f.light + f.k_t * f.m_t * canvas.light(f.pixel);
            else
                rest.push_back(i);
        }
        left = rest;
    }
}

}
