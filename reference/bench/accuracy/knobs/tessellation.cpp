#include <fmt/format.h>

#include <functional>
#include <list>
#include <umbral/gl/context.hpp>

#include "../ball_painter.hpp"
#include "../knee.hpp"
#include "../knob.hpp"
#include "../law.hpp"
#include "../timing.hpp"

namespace umbral::bench {
namespace {

constexpr double degrees = 57.29577951308232;

struct Grid {
    int sectors;
    int rings;
};

/// Powers of two, from half as many sectors as rings to four times as many.
std::vector<Grid> grids(int most)
{
    std::vector<Grid> all;
    for (int rings = 4; rings <= most; rings *= 2)
        for (int sectors = rings / 2; sectors <= 4 * rings; sectors *= 2)
            if (sectors >= 4 && sectors <= most) all.push_back({sectors, rings});
    return all;
}

}

Knob measure_tessellation(Means& means)
{
    Knob knob{.id = "tessellation",
              .title = "A sphere made of triangles",
              .text = "",
              .time_unit = "ms per frame",
              .axis = "",
              .measures = {{"silhouette_px", "error of the silhouette", "px"},
                           {"distance_percent", "distance to the true sphere", "% of the radius"},
                           {"normal_degrees", "angle of the facets' normals", "degrees"}},
              .situations = {{"frame", fmt::format("{0} × {0} pixels", BallPainter::size), 1}},
              .settings = {},
              .results = {},
              .curves = {}};
    knob.text = fmt::format(
        "A sphere of {} pixels' radius in a picture of {} × {}, one lamp for each pixel, drawn by OpenGL on one "
        "processor thread. “64x32” has 64 sectors round "
        "the axis and 32 rings from pole to pole. Errors are the largest there are, computed from the corners in "
        "double; the time is that of a frame with the "
        "mesh uploaded.",
        BallPainter::radius, BallPainter::size, BallPainter::size);
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    means.gl = gl::backend_description();
    const BallPainter painter;
    std::list<gl::Mesh> meshes;
    std::vector<std::function<void()>> work;
    for (const auto& [sectors, rings] : grids(means.quick ? 128 : 1024)) {
        const BallMesh ball = ball_mesh(sectors, rings);
        const BallErrors errors = errors_of(ball, BallPainter::towards_eye());
        knob.settings.emplace_back(fmt::format("{}x{}", sectors, rings),
                                   fmt::format("{} triangles", ball.indices.size() / 3));
        knob.results.push_back({knob.settings.back().first,
                                "frame",
                                0,
                                {{"silhouette_px", BallPainter::radius * errors.silhouette},
                                 {"distance_percent", 100 * errors.distance},
                                 {"normal_degrees", degrees * errors.angle}},
                                sectors == 2 * rings ? "2 : 1" : "",
                                sectors == 2 * rings ? static_cast<double>(ball.indices.size() / 3) : 0});
        meshes.emplace_back(ball.positions, ball.positions, ball.indices);
        work.emplace_back([&painter, &mesh = meshes.back()] { painter.draw(mesh); });
    }
    const std::vector<double> seconds =
        fastest_of_interleaved(work, means.quick ? Patience{5, 3, 1, 0.01} : Patience{40, 5, 40, 0.02});
    for (std::size_t i = 0; i < seconds.size(); ++i) knob.results[i].time = 1e3 * seconds[i];
    for (const Measure& measure : knob.measures) knob.curves.push_back(curve_of(knob, "frame", measure.id));
    const std::string squares = "A chord leaves its arc by the square of its length, and a triangle has the area of ";
    knob.laws = {
        law_of(knob, {"2 : 1", "distance_percent", "triangles", -1, squares + "such a square.",
                      "Meshes of few triangles are no small parts of a sphere."}),
        law_of(knob, {"2 : 1", "normal_degrees", "triangles", -0.5, "A facet's normal is off by its own width.",
                      "Meshes of few triangles are no small parts of a sphere."})};
    return knob;
}

}
