#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>

#include "bench/scenes/scenes.hpp"

namespace umbral::bench::scenes {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Options {
    std::string folder;
    std::string gl = "osmesa";
    int size = 256;
    bool list = false;
};

class Writer {
public:
    Writer(fs::path folder, Painters& painters) : folder_(std::move(folder)), painters_(painters) {}

    json write(const Scene& scene)
    {
        const std::string place = joined(scene.name, '-');
        fs::create_directories(folder_ / place);
        const Image expected = scene.draw(painters_, Flaw::none, Way::as_it_is);
        write_png(folder_ / place / "expected.png", expected);
        json variants = json::array();
        const auto add = [&](const Operator& shown, bool harmful, const Image& image) {
            const std::string file = place + "/" + joined(shown.name, '-') + ".png";
            write_png(folder_ / file, image);
            json variant = {{"operator", shown.name}, {"harmful", harmful}, {"about", shown.about}, {"file", file}};
            if (image.cells == expected.cells) variant["equal"] = true;
            variants.push_back(variant);
        };
        for (const Way way : scene.ways)
            if (painters_.has(way)) add(operator_of(way), false, scene.draw(painters_, Flaw::none, way));
        for (const Flaw flaw : scene.flaws) add(operator_of(flaw), true, scene.draw(painters_, flaw, Way::as_it_is));
        return {{"name", scene.name},
                {"about", scene.about},
                {"noise", scene.noise},
                {"expected", place + "/expected.png"},
                {"variants", variants}};
    }

private:
    fs::path folder_;
    Painters& painters_;
};

void list(const std::vector<Scene>& scenes)
{
    for (const Scene& scene : scenes) {
        fmt::print("{}: {}\n  harmless:", scene.name, scene.about);
        for (const Way way : scene.ways) fmt::print(" {};", operator_of(way).name);
        fmt::print("\n  harmful:");
        for (const Flaw flaw : scene.flaws) fmt::print(" {};", operator_of(flaw).name);
        fmt::print("\n");
    }
}

void draw(const std::vector<Scene>& scenes, const Options& options)
{
    gl::forbid_driver_threads();
    Painters painters(*gl::backend_named(options.gl));
    const fs::path folder = options.folder;
    Writer writer(folder, painters);
    json all = json::array();
    std::size_t count = 0;
    for (const Scene& scene : scenes) {
        all.push_back(writer.write(scene));
        count += 1 + all.back()["variants"].size();
    }
    const json document = {{"format", 1}, {"gl", options.gl + ", " + painters.description()}, {"scenes", all}};
    const std::string text = document.dump(2) + "\n";
    write_file_atomically(folder / "pictures.json", std::as_bytes(std::span(text)));
    fmt::print("{} scenes, {} pictures: {}\n", all.size(), count, (folder / "pictures.json").string());
}

}
}

int main(int count, char** words)
{
    using namespace umbral::bench::scenes;
    Options options;
    CLI::App parser(
        "Draws the scenes on which judges of pictures are calibrated: right, right in other ways, and wrong.",
        "umbral-bench-scenes");
    parser.add_option("folder", options.folder, "Where pictures.json and a folder for each scene go");
    parser.add_option("--gl", options.gl, "Who draws OpenGL's part")
        ->check(CLI::IsMember({"osmesa", "egl"}))
        ->capture_default_str();
    parser.add_option("--size", options.size, "Side of most pictures, in pixels")
        ->check(CLI::Range(64, 1024))
        ->capture_default_str();
    parser.add_flag("--list", options.list, "Only name the scenes and what is done to them");
    try {
        parser.parse(count, words);
        if (!options.list && options.folder.empty()) throw CLI::RequiredError("folder");
    } catch (const CLI::ParseError& error) {
        return parser.exit(error) == 0 ? 0 : 2;
    }
    try {
        const std::vector<Scene> scenes = all_scenes(options.size);
        if (options.list)
            list(scenes);
        else
            draw(scenes, options);
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-bench-scenes: %s\n", error.what());
        return 3;
    }
}
