// Compiled several times, each time into a library of its own: UMBRAL_BUILD is its namespace, UMBRAL_REAL what it
// computes in.

#include "software.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <umbral/pipeline/clip.hpp>
#include <umbral/pipeline/rasterize.hpp>

#include "mipmaps.hpp"
#include "shading.hpp"

namespace umbral::bench::scenes {
namespace {

using Real = UMBRAL_REAL;
using S = Shading<Real>;
using vec2 = S::vec2;
using vec3 = S::vec3;
using vec4 = S::vec4;

struct Corner {
    S::Placed placed;
    vec2 uv;
    vec4 color;
};

int wrapped(int i, int size, bool repeat) { return repeat ? ((i % size) + size) % size : std::clamp(i, 0, size - 1); }

vec4 fetched(const Grid<glm::vec4>& level, const vec2& uv, bool linear, bool repeat)
{
    const auto texel = [&](int x, int y) {
        return vec4(level.at(wrapped(x, level.width, repeat), wrapped(y, level.height, repeat)));
    };
    const vec2 at = uv * vec2(level.width, level.height) - (linear ? Real(0.5) : Real(0));
    const vec2 low = glm::floor(at);
    const int x = static_cast<int>(low.x);
    const int y = static_cast<int>(low.y);
    if (!linear) return texel(x, y);
    const vec2 part = at - low;
    return mix(mix(texel(x, y), texel(x + 1, y), part.x), mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
}

/// The plane in which a quantity lies that is affine on the screen: its growth to the right and down.
vec2 growth(const std::array<pipeline::WindowVertex, 3>& t, const vec3& values)
{
    const vec2 b = vec2(t[1].position - t[0].position);
    const vec2 c = vec2(t[2].position - t[0].position);
    const Real area = b.x * c.y - b.y * c.x;
    const Real db = values.y - values.x;
    const Real dc = values.z - values.x;
    return vec2(db * c.y - dc * b.y, dc * b.x - db * c.x) / area;
}

}

template <>
vec4 Shading<Real>::lookup(vec2 uv, Real lod) const
{
    const Real top = static_cast<Real>(levels->size() - 1);
    const Real level = clamp(lod, Real(0), top);
    const auto low = static_cast<std::size_t>(level);
    const vec4 fine = fetched((*levels)[low], uv, image->linear, image->repeat);
    if (low + 1 >= levels->size() || level == glm::floor(level)) return fine;
    return mix(fine, fetched((*levels)[low + 1], uv, image->linear, image->repeat), level - glm::floor(level));
}

namespace {

/// What is drawn so far.
class Canvas {
public:
    Canvas(const Model& model, Flaw flaw, Way way)
        : model_(model), flaw_(flaw), way_(way), image_(model.width, model.height), depth_(model.width, model.height)
    {
        std::fill(image_.cells.begin(), image_.cells.end(), bytes(vec4(model.background)));
        std::fill(depth_.cells.begin(), depth_.cells.end(), model.farthest_wins ? 0.0F : 1.0F);
    }

    void draw(const Batch& batch)
    {
        if (batch.lines) throw std::invalid_argument("umbral-bench-scenes: lines are drawn by OpenGL only");
        batch_ = &batch;
        prepare(shading_, model_, batch, flaw_, way_);
        levels_ = batch.texture ? mipmaps(model_.textures[*batch.texture]) : std::vector<Grid<glm::vec4>>();
        shading_.levels = &levels_;
        for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
            const std::array<Corner, 3> corners = {place(batch.corners[i]), place(batch.corners[i + 1]),
                                                   place(batch.corners[i + 2])};
            clip(corners);
        }
    }

    [[nodiscard]] Image picture() const { return image_; }

private:
    [[nodiscard]] Corner place(const Vertex& v)
    {
        return {shading_.placed(vec3(v.position), vec3(v.normal)), vec2(v.uv), vec4(v.color)};
    }

    static glm::u8vec4 bytes(const vec4& color)
    {
        return glm::u8vec4(glm::floor(clamp(color, Real(0), Real(1)) * Real(255) + Real(0.5)));
    }

    void clip(const std::array<Corner, 3>& t)
    {
        const std::array<glm::vec4, 3> positions = {glm::vec4(t[0].placed.clip), glm::vec4(t[1].placed.clip),
                                                    glm::vec4(t[2].placed.clip)};
        const unsigned a = pipeline::outside_planes(positions[0]);
        const unsigned b = pipeline::outside_planes(positions[1]);
        const unsigned c = pipeline::outside_planes(positions[2]);
        if ((a & b & c) != 0) return;
        // x and y need no clipping within the rasteriser's guard band.
        constexpr unsigned depth_planes = 0x70;
        if (((a | b | c) & depth_planes) == 0) {
            rasterize(t);
            return;
        }
        polygon_.clear();
        pipeline::clip_triangle(positions, polygon_);
        std::vector<Corner> corners;
        for (const pipeline::ClipVertex& v : polygon_) {
            const vec3 w(v.weights);
            const auto mixed = [&](const auto& f) { return f(t[0]) * w.x + f(t[1]) * w.y + f(t[2]) * w.z; };
            corners.push_back({{vec4(v.position), mixed([](const Corner& k) { return k.placed.place; }),
                                mixed([](const Corner& k) { return k.placed.normal; })},
                               mixed([](const Corner& k) { return k.uv; }),
                               mixed([](const Corner& k) { return k.color; })});
        }
        for (std::size_t i = 2; i < corners.size(); ++i) rasterize({corners[0], corners[i - 1], corners[i]});
    }

    [[nodiscard]] pipeline::WindowVertex window(const vec4& p) const
    {
        const Real inverse_w = 1 / p.w;
        const vec2 half = vec2(model_.width, model_.height) * Real(0.5);
        return {glm::vec2(p.x * inverse_w * half.x + half.x, half.y - p.y * inverse_w * half.y),
                static_cast<float>(p.z * inverse_w * Real(0.5) + Real(0.5)), static_cast<float>(inverse_w)};
    }

    void rasterize(const std::array<Corner, 3>& t)
    {
        const std::array<pipeline::WindowVertex, 3> w = {window(t[0].placed.clip), window(t[1].placed.clip),
                                                         window(t[2].placed.clip)};
        if (batch_->cull != Cull::none) {
            const glm::vec2 b = w[1].position - w[0].position;
            const glm::vec2 c = w[2].position - w[0].position;
            if (const bool front = b.x * c.y - b.y * c.x < 0; front == (batch_->cull == Cull::front)) return;
        }
        fragments_.clear();
        pipeline::rasterize_triangle(w, model_.width, model_.height, fragments_);
        if (fragments_.empty()) return;
        const vec3 inverse_w(w[0].inverse_w, w[1].inverse_w, w[2].inverse_w);
        const std::array<vec2, 3> slopes = {growth(w, inverse_w),
                                            growth(w, vec3(t[0].uv.x, t[1].uv.x, t[2].uv.x) * inverse_w),
                                            growth(w, vec3(t[0].uv.y, t[1].uv.y, t[2].uv.y) * inverse_w)};
        for (const pipeline::Fragment& f : fragments_) {
            float& depth = depth_.at(f.pixel.x, f.pixel.y);
            if (batch_->depth_test && !(model_.farthest_wins ? f.depth > depth : f.depth < depth)) continue;
            const vec4 color = shading_.shaded(surface(t, inverse_w, vec3(f.weights), slopes));
            if (color.w < 0) continue;
            if (batch_->depth_write && batch_->depth_test) depth = f.depth;
            blend(image_.at(f.pixel.x, f.pixel.y), color);
        }
    }

    [[nodiscard]] S::Surface surface(const std::array<Corner, 3>& t, const vec3& inverse_w, const vec3& weights,
                                     const std::array<vec2, 3>& slopes) const
    {
        const auto mixed = [&](const auto& f, const vec3& k) { return f(t[0]) * k.x + f(t[1]) * k.y + f(t[2]) * k.z; };
        const auto uv_of = [](const Corner& k) { return k.uv; };
        S::Surface at;
        at.place = mixed([](const Corner& k) { return k.placed.place; }, weights);
        at.normal = mixed([](const Corner& k) { return k.placed.normal; }, weights);
        at.uv = mixed(uv_of, weights);
        const vec3 shares = weights / inverse_w;
        at.affine = mixed(uv_of, shares / (shares.x + shares.y + shares.z));
        at.color = mixed([](const Corner& k) { return k.color; }, weights);
        at.lod = 0;
        if (levels_.size() > 1) {
            const Real w = dot(weights, Real(1) / inverse_w);
            const vec2 du = (slopes[1] - at.uv.x * slopes[0]) * w;
            const vec2 dv = (slopes[2] - at.uv.y * slopes[0]) * w;
            const vec2 texels = shading_.uv_scale / shading_.texel;
            const vec2 right = vec2(du.x, dv.x) * texels;
            const vec2 down = vec2(du.y, dv.y) * texels;
            at.lod = log2(max(max(dot(right, right), dot(down, down)), Real(1e-12))) / 2;
        }
        return at;
    }

    void blend(glm::u8vec4& pixel, const vec4& color) const
    {
        const vec4 c = clamp(color, Real(0), Real(1));
        const vec4 old = vec4(pixel) / Real(255);
        if (batch_->blend == Blend::none) pixel = bytes(c);
        if (batch_->blend == Blend::over)
            pixel = bytes(way_ == Way::equal_formulas ? old + c.w * (c - old) : c * c.w + old * (1 - c.w));
        if (batch_->blend == Blend::add) pixel = bytes(c * c.w + old);
        pixel.a = 255;
    }

    const Model& model_;
    Flaw flaw_;
    Way way_;
    Image image_;
    Grid<float> depth_;
    const Batch* batch_ = nullptr;
    S shading_;
    std::vector<Grid<glm::vec4>> levels_;
    std::vector<pipeline::Fragment> fragments_;
    std::vector<pipeline::ClipVertex> polygon_;
};

}

namespace UMBRAL_BUILD {

Image paint(const Model& model, Flaw flaw, Way way)
{
    Canvas canvas(model, flaw, way);
    for (const Batch& batch : model.batches) canvas.draw(batch);
    return canvas.picture();
}

// drafting.cpp and tracing.cpp
Image draft(const Drawing& drawing, Flaw flaw, Way way);
Image trace(const Traced& world, Flaw flaw, Way way);

SoftwareBuild build() { return {paint, draft, trace}; }

}

}
