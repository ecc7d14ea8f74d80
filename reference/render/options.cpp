#include "render/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <vector>

#include "render/renderers.hpp"

namespace umbral::render {
namespace {

std::string shown(const std::string& text)
{
    std::string clean = text.substr(0, 40);
    std::replace_if(
        clean.begin(), clean.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F; }, '?');
    return clean;
}

std::optional<int> side(const char* begin, const char* end)
{
    int value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || value < 1 || value > maximum_side) return std::nullopt;
    return value;
}

std::vector<std::string> names_of_renderers()
{
    std::vector<std::string> names;
    for (const Renderer& renderer : all_renderers()) names.emplace_back(renderer.name);
    return names;
}

std::string what_renderers_do()
{
    std::string text;
    for (const Renderer& renderer : all_renderers())
        text += (text.empty() ? "" : "; ") + std::string(renderer.name) + ": " + renderer.does;
    return text;
}

void check_wish(const Options& options)
{
    if (!options.wish) return;
    if (options.renderer != "raytrace" || options.compare)
        throw UsageError(
            "--error and --time choose rays, and depth and bounces of light: expected --renderer raytrace " +
            std::string(options.compare ? "and no --compare" : "(got " + options.renderer + ")"));
    if (options.effort.rays != 1 || options.samples != 1)
        throw UsageError("--error and --time choose how many rays there are: leave out --rays and --samples");
}

void check(const Options& options)
{
    check_wish(options);
    if (options.compare && (!options.out.empty() || !options.buffers.empty()))
        throw UsageError("--compare draws with all renderers and writes nothing: leave out --out and --buffers");
    if (!options.compare && options.out.empty() && options.buffers.empty() && !options.explain && !options.wish)
        throw UsageError("nothing to do: expected --out PNG, --buffers DIR, --explain, --error, --time or --compare");
    const FilmOptions& film = options.film;
    if ((film.seconds > 0 || !film.film.empty()) && film.pictures == 0)
        throw UsageError("--seconds and --film go with --animate N, which says how many pictures");
    if (film.pictures > 0 && (options.out.empty() || !options.buffers.empty() || options.explain || options.json ||
                              options.compare || options.wish))
        throw UsageError("--animate writes numbered pictures beside --out PNG, and nothing else but --film");
    if (options.compare && options.samples != 1)
        throw UsageError("--compare looks at single samples: leave out --samples");
    if (1LL * options.size.width * options.size.height * options.samples * options.samples > maximum_samples)
        throw UsageError("expected at most " + std::to_string(maximum_samples) + " samples in all, got " +
                         std::to_string(options.size.width) + " x " + std::to_string(options.size.height) +
                         " pixels of " + std::to_string(options.samples) + " x " + std::to_string(options.samples) +
                         ": choose a smaller --size or --samples");
}

}

Size parse_size(const std::string& text)
{
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = side(text.data(), text.data() + cross);
        const auto height = side(text.data() + cross + 1, text.data() + text.size());
        if (width && height) return {*width, *height};
    }
    throw UsageError("--size: expected WIDTHxHEIGHT with sides of 1 to " + std::to_string(maximum_side) +
                     " pixels, as 512x384, got '" + shown(text) + "'");
}

std::optional<Options> parse_options(int count, char** words, int& status)
{
    Options options;
    std::string size = "512x512";
    std::string kernel = "derived";
    std::string wished_error;
    std::string wished_time;
    CLI::App parser("Draws a scene with the reference engine.", "umbral render");
    parser.add_option("SCENE", options.scene, "The scene, a JSON file; with --compare also a folder of them")
        ->required();
    parser.add_option("--renderer", options.renderer, "Who draws: " + what_renderers_do())
        ->check(CLI::IsMember(names_of_renderers()))
        ->capture_default_str();
    parser.add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    parser.add_option("--samples", options.samples, "N: N x N samples a pixel, in the picture only")
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    parser.add_option("--rays", options.effort.rays, "raytrace: rays through each sample")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    parser.add_option("--threads", options.effort.threads, "raytrace: 0 for one on each processor")
        ->check(CLI::Range(0, 256))
        ->capture_default_str();
    parser.add_option("--error", wished_error,
                      "raytrace: the cheapest picture of at most this error, as 1%; says what it took");
    parser.add_option("--time", wished_time, "raytrace: the most accurate picture within this time, as 2s or 250ms");
    parser.add_option("--out", options.out, "The picture, a PNG file");
    parser.add_option("--buffers", options.buffers,
                      "A folder for depth, ids, coverage and linear colour, as .npy and .png");
    parser.add_option("--animate", options.film.pictures, "N pictures of what moves, with numbers: OUT-0000.png …")
        ->check(CLI::Range(1, most_pictures));
    parser.add_option("--seconds", options.film.seconds, "--animate: how long they last; else what the scene says")
        ->check(CLI::Range(0.001, 3600.0));
    parser.add_option("--film", options.film.film, "--animate: a film of them too, made by ffmpeg: FILE.mp4");
    parser.add_flag("--progress", options.progress, "Say on standard error how much is done, and how long it takes");
    parser.add_flag("--explain", options.explain,
                    "Say which effects the scene calls for, why, and how much work was done");
    parser.add_flag("--compare", options.compare, "Draw with all renderers and say how far apart they are, and why");
    parser
        .add_option("--kernel", kernel,
                    "derived: only what the scene calls for; all: the kernel with every effect, for comparison")
        ->check(CLI::IsMember({"derived", "all"}))
        ->capture_default_str();
    parser.add_flag("--json", options.json, "Say it in JSON");
    parser.footer(
        "Exit status: 0 all right; 1 the renderers differ by more than is allowed; 2 the command cannot be carried out "
        "as given; 3 a fault of Umbral's own.");
    try {
        parser.parse(count, words);
    } catch (const CLI::ParseError& error) {
        status = parser.exit(error) == 0 ? exit_ok : exit_usage;
        return std::nullopt;
    }
    options.all_effects = kernel == "all";
    options.size = parse_size(size);
    try {
        if (parser.count("--error") + parser.count("--time") != 0)
            options.wish = budget::parse_wish(wished_error, wished_time);
    } catch (const std::runtime_error& fault) {
        throw UsageError(fault.what());
    }
    check(options);
    return options;
}

}
