// Pictures in two dimensions: polygons filled, and lines stepped, by programs of our own.

#include <cmath>
#include <umbral/core/random.hpp>

#include "drafting.hpp"
#include "scenes.hpp"
#include "staging.hpp"

namespace umbral::bench::scenes {
namespace {

using DraftBuild = std::function<Drawing(const Pose&)>;

glm::u8vec4 ink(int r, int g, int b) { return {r, g, b, 255}; }

/// Corners at alternating distances: concave, but seen whole from the middle.
Polygon star_shape(const glm::vec2& middle, float outer, float inner, int points, float turn, const glm::u8vec4& color)
{
    Polygon p{{}, middle, color};
    for (int i = 0; i < 2 * points; ++i) {
        const float a = turn + 3.14159265F * static_cast<float>(i) / static_cast<float>(points);
        p.corners.push_back(middle + (i % 2 == 0 ? outer : inner) * glm::vec2(std::cos(a), std::sin(a)));
    }
    return p;
}

Drawing shapes(const Pose& pose, const glm::u8vec4& background, bool pale)
{
    Drawing d;
    d.width = d.height = pose.size;
    d.background = background;
    const float s = static_cast<float>(pose.size) / 256;
    const float turn = 0.1F * pose.time();
    Random random(41);
    const int base = pale ? 120 : 20;
    const auto color = [&] {
        const int r = base + static_cast<int>(random.below(110));
        const int g = base + static_cast<int>(random.below(110));
        return ink(r, g, base + static_cast<int>(random.below(110)));
    };
    d.polygons.push_back(star_shape({78.3F * s, 80.7F * s}, 62 * s, 24 * s, 5, turn + 0.3F, color()));
    d.polygons.push_back(star_shape({184.4F * s, 76.2F * s}, 50 * s, 42 * s, 9, turn, color()));
    // Corners on the middle of rows, and horizontal sides.
    d.polygons.push_back({{{40.5F * s, 160.5F * s},
                           {110.5F * s, 160.5F * s},
                           {110.5F * s, 190.5F * s},
                           {75.5F * s, 215.5F * s},
                           {40.5F * s, 190.5F * s}},
                          {75.5F * s, 180.5F * s},
                          color()});
    d.polygons.push_back(star_shape({178.6F * s, 182.3F * s}, 56 * s, 17 * s, 7, turn, color()));
    d.polygons.push_back(star_shape({128.2F * s, 128.9F * s}, 20 * s, 19 * s, 3, turn + 1, color()));
    return d;
}

Drawing on_white(const Pose& pose) { return shapes(pose, ink(255, 255, 255), false); }
Drawing on_black(const Pose& pose) { return shapes(pose, ink(0, 0, 0), true); }

// Lines of every slope, short and long ones.
Drawing stepped(const Pose& pose)
{
    Drawing d;
    d.width = d.height = pose.size;
    d.background = ink(250, 248, 240);
    const int s = pose.size;
    const int t = static_cast<int>(2 * pose.time());
    for (int i = 0; i <= 20; ++i)
        d.segments.push_back(
            {{s / 16 + t, s / 16}, {s / 16 + t + i * s / 40, s / 16 + (20 - i) * s / 40}, ink(150 - 7 * i, 30, 7 * i)});
    for (int i = 0; i < 23; ++i) {
        const float a = 6.2831853F * static_cast<float>(i) / 23;
        const float b = 6.2831853F * static_cast<float>(i * 5 % 23) / 23;
        const auto on_ring = [&](float angle) {
            return glm::ivec2(s * 7 / 10 + t, s * 7 / 10) +
                   glm::ivec2(glm::vec2(std::cos(angle), std::sin(angle)) * (0.25F * static_cast<float>(s)));
        };
        d.segments.push_back({on_ring(a), on_ring(b), ink(20, 90, 60)});
    }
    return d;
}

/// The same by OpenGL: each polygon as a fan from its middle, or, wrongly, from its first corner.
Model as_model(const Drawing& d, Flaw flaw)
{
    Model m = flat_picture(d.width, d.height, static_cast<float>(d.height));
    m.background = glm::vec4(d.background) / 255.0F;
    for (const Polygon& p : d.polygons) {
        Batch batch = solid({}, glm::mat4(1), plain_paint(glm::vec4(p.color) / 255.0F));
        batch.cull = Cull::none;
        batch.depth_test = false;
        const glm::vec2 first = flaw == Flaw::fan_for_polygon ? p.corners[0] : p.middle;
        for (std::size_t i = 0; i < p.corners.size(); ++i)
            for (const glm::vec2& corner : {first, p.corners[i], p.corners[(i + 1) % p.corners.size()]}) {
                Vertex v;
                v.position = {corner.x - 0.5F * static_cast<float>(d.width),
                              0.5F * static_cast<float>(d.height) - corner.y, 0};
                batch.corners.push_back(v);
            }
        m.batches.push_back(batch);
    }
    return m;
}

Scene draft_scene(std::string name, std::string about, int size, DraftBuild build, std::vector<Flaw> flaws,
                  std::vector<Way> ways)
{
    Scene scene;
    scene.name = std::move(name);
    scene.about = std::move(about);
    scene.flaws = std::move(flaws);
    scene.ways = std::move(ways);
    scene.draw = [size, build = std::move(build)](Painters& painters, Flaw flaw, Way way) {
        Drawing drawing = build({size, flaw});
        if (flaw == Flaw::blank) drawing.polygons.clear();
        if (flaw == Flaw::blank) drawing.segments.clear();
        if (flaw == Flaw::missing_edge) drawing.segments.erase(drawing.segments.begin() + 30);
        if (way == Way::other_renderer || flaw == Flaw::fan_for_polygon)
            return painters.opengl(as_model(drawing, flaw), flaw, way);
        return Painters::software(way).draft(drawing, flaw, way);
    };
    return finish(scene);
}

}

std::vector<Scene> polygon_scenes(int size)
{
    using enum Flaw;
    const std::vector<Way> ways = {Way::other_renderer, Way::not_optimised,    Way::fused_multiply_add,
                                   Way::other_compiler, Way::double_precision, Way::incremental_steps,
                                   Way::equal_formulas, Way::ends_swapped};
    const std::vector<Flaw> fills = {
        half_pixel_centre, floor_for_round,  shifted_one_pixel,    upside_down,       mirrored,        blank,
        red_blue_swapped,  ends_both_filled, vertex_counted_twice, last_edge_missing, fan_for_polygon, stale_frame};
    return {
        draft_scene("polygons on white", "Concave polygons filled by scan lines, on white.", size, on_white, fills,
                    ways),
        draft_scene("polygons on black", "The same shapes, pale, on black.", size, on_black, fills, ways),
        draft_scene(
            "stepped lines", "Lines of every slope, stepped pixel by pixel.", size, stepped,
            {half_pixel_centre, floor_for_round, shifted_one_pixel, upside_down, mirrored, blank, red_blue_swapped,
             missing_edge, line_width_wrong, steep_lines_gappy, line_end_missing, stale_frame},
            {Way::not_optimised, Way::fused_multiply_add, Way::other_compiler, Way::double_precision,
             Way::incremental_steps, Way::ends_swapped}),
    };
}

}
