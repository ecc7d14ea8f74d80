// bench-raster: triangles and pixels a second of the engine's rasteriser and of Mesa's llvmpipe, each on one thread, in
// one run.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <umbral/gl/context.hpp>

#include "bench/accuracy/timing.hpp"
#include "raster.hpp"

namespace {

using namespace umbral;
using namespace umbral::bench;

constexpr int side = 1024;

struct Row {
    int legs;
    bool scattered;
    double triangles;
    double pixels;          ///< by the triangles' area
    double ours, gl;        ///< seconds, without clearing
    std::size_t different;  ///< pixels with a channel more than 1/255 apart
};

bool is_close(std::uint32_t a, std::uint32_t b)
{
    for (unsigned shift = 0; shift < 24; shift += 8)
        if (std::abs(static_cast<int>((a >> shift) & 255U) - static_cast<int>((b >> shift) & 255U)) > 1) return false;
    return true;
}

std::size_t differing(const Grid<std::uint32_t>& a, const Grid<std::uint32_t>& b)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.cells.size(); ++i) count += is_close(a.cells[i], b.cells[i]) ? 0U : 1U;
    return count;
}

Row measure(int legs, bool scattered, double seconds)
{
    const std::vector<RasterVertex> vertices = raster_workload(legs, side, scattered);
    const auto ours = make_our_raster(vertices, side);
    const auto gl = make_gl_raster(vertices, side);
    const std::array<std::function<void()>, 4> variants = {[&] { ours->clear(); }, [&] { gl->clear(); },
                                                           [&] { ours->draw(); }, [&] { gl->draw(); }};
    const std::vector<double> fastest =
        fastest_of_interleaved(variants, {.rounds = 200, .least = 5, .seconds = seconds});
    ours->draw();
    gl->draw();
    const auto triangles = static_cast<double>(vertices.size() / 3);
    return {legs,
            scattered,
            triangles,
            0.5 * legs * legs * triangles,
            fastest[2] - fastest[0],
            fastest[3] - fastest[1],
            differing(ours->picture(), gl->picture())};
}

nlohmann::json to_json(const Row& row)
{
    return {{"legs", row.legs},
            {"order", row.scattered ? "scattered" : "mesh"},
            {"ours_triangles_per_second", row.triangles / row.ours},
            {"gl_triangles_per_second", row.triangles / row.gl},
            {"ours_pixels_per_second", row.pixels / row.ours},
            {"gl_pixels_per_second", row.pixels / row.gl},
            {"ratio", row.gl / row.ours},
            {"pixels_differing", row.different}};
}

std::string to_line(const Row& row)
{
    return fmt::format("{:9} {:5} {:12.3f} {:10.3f} {:12.1f} {:10.1f} {:8.2f} {:10}\n",
                       row.scattered ? "scattered" : "mesh", row.legs, 1e-6 * row.triangles / row.ours,
                       1e-6 * row.triangles / row.gl, 1e-6 * row.pixels / row.ours, 1e-6 * row.pixels / row.gl,
                       row.gl / row.ours, row.different);
}

/// The table of the README: meshes alone, a column a size.
std::string readme_table(const std::vector<Row>& rows)
{
    std::string legs = "| legs of the triangles, pixels |";
    std::string line = "\n|---|";
    std::string ours = "\n| million triangles a second, ours |";
    std::string ratio = "\n| ours over llvmpipe's |";
    for (const Row& row : rows) {
        if (row.scattered) continue;
        legs += fmt::format(" {} |", row.legs);
        line += "---|";
        ours += fmt::format(" {:#.3g} |", 1e-6 * row.triangles / row.ours);
        ratio += fmt::format(" {:.2f} |", row.gl / row.ours);
    }
    return legs + line + ours + ratio + "\n";
}

}

int main(int count, char** words)
{
    CLI::App app(
        "Measures the engine's rasteriser against Mesa's llvmpipe: the same triangles, in turns, one thread each.",
        "umbral bench raster");
    double seconds = 8;
    bool json = false;
    std::vector<int> sizes = {2, 4, 8, 16, 32, 64, 128, 256};
    app.add_option("--seconds", seconds, "How long to measure a row, about")->capture_default_str()->take_last();
    app.add_option("--legs", sizes, "Legs of the triangles, in pixels")->check(CLI::Range(1, 512));
    app.add_flag("--json", json, "Say it in JSON");
    CLI11_PARSE(app, count, words);

    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    std::vector<Row> rows;
    if (!json)
        fmt::print(
            "{}, {} x {}; legs in pixels; ratio: ours to llvmpipe\n{:9} {:>5} {:>12} {:>10} {:>12} {:>10} {:>8} "
            "{:>10}\n",
            gl::backend_description(), side, side, "order", "legs", "ours Mtri/s", "llvmpipe", "ours Mpix/s",
            "llvmpipe", "ratio", "different");
    for (const bool scattered : {false, true})
        for (const int legs : sizes) {
            rows.push_back(measure(legs, scattered, seconds));
            if (!json) fmt::print("{}", to_line(rows.back()));
            (void)std::fflush(stdout);
        }
    if (!json) {
        fmt::print("\n{}", readme_table(rows));
        return 0;
    }
    nlohmann::json all = nlohmann::json::array();
    for (const Row& row : rows) all.push_back(to_json(row));
    fmt::print("{}\n", nlohmann::json{{"gl", gl::backend_description()}, {"side", side}, {"rows", all}}.dump(2));
}
