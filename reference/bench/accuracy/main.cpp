#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "json.hpp"
#include "knob.hpp"
#include "markdown.hpp"
#include "page.hpp"
#include "text.hpp"

// umbral-bench-accuracy: started by `umbral bench`, since the grader knows no reference.
namespace {

namespace fs = std::filesystem;
using namespace umbral::bench;

struct Options {
    fs::path units;
    std::vector<std::string> knobs;
    std::vector<std::string> named;
    std::string out = "out/bench";
    bool json = false;
    bool quick = false;
    std::string html;
    std::string markdown;
};

std::vector<std::string> knob_names()
{
    std::vector<std::string> names;
    for (const KnobEntry& entry : all_knobs()) names.emplace_back(entry.id);
    return names;
}

std::string processor()
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name") || line.starts_with("CPU part"))
            return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
}

Accuracy measure(const Options& options)
{
    Accuracy accuracy{processor(), UMBRAL_BENCH_COMPILER, "", options.quick, {}};
    Means means{options.units, options.quick, ""};
    for (const KnobEntry& entry : all_knobs()) {
        if (!options.knobs.empty() &&
            std::find(options.knobs.begin(), options.knobs.end(), entry.id) == options.knobs.end())
            continue;
        (void)std::fprintf(stderr, "measuring %s …\n", entry.id);
        accuracy.knobs.push_back(entry.measure(means));
    }
    accuracy.gl = means.gl;
    return accuracy;
}

fs::path write(const fs::path& file, const std::string& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush())
        throw std::runtime_error("cannot write " + file.string() +
                                 ": is the disk full, or the folder not yours? --out DIR chooses another");
    return file;
}

void run(const Options& options)
{
    const Accuracy accuracy = measure(options);
    const fs::path out = fs::absolute(options.out);
    const std::string json = to_json(accuracy).dump(2) + "\n";
    const fs::path data = write(out / "accuracy.json", json);
    const fs::path page =
        write(options.html.empty() ? out / "accuracy.html" : fs::absolute(options.html), page_of(accuracy));
    if (!options.markdown.empty()) write(fs::absolute(options.markdown), markdown_of(accuracy));
    if (options.json)
        fmt::print("{}", json);
    else
        fmt::print("{}\n{}\n{}\n", text_of(accuracy), page.string(), data.string());
}

}

int main(int count, char** words)
{
    Options options;
    // In a build as in an installation they lie beside the folder of the programs.
    options.units = fs::canonical("/proc/self/exe").parent_path().parent_path() / "units";
    CLI::App parser("Measures what accuracy costs in time.", "umbral bench");
    parser.require_subcommand(1);
    CLI::App* command = parser.add_subcommand(
        "accuracy", "Error against time for every knob that trades one for the other, with its knee marked");
    command->add_option("--knob", options.named, "Only this one (may be repeated)")->check(CLI::IsMember(knob_names()));
    command->add_option("--out", options.out, "Where accuracy.html and accuracy.json go")->capture_default_str();
    command->add_option("knobs", options.knobs, "Only these knobs; all if none is named")
        ->check(CLI::IsMember(knob_names()));
    command->add_option("--html", options.html, "Where the page goes, if not to accuracy.html in --out");
    command->add_option("--markdown", options.markdown, "Also write the table of all knobs to this file");
    command->add_flag("--json", options.json, "Print the JSON instead of tables");
    command->add_flag("--quick", options.quick, "A look in seconds: few samples and settings");
    command->add_option("--units", options.units, "Where the build keeps the units' libraries")
        ->capture_default_str()
        ->group("");
    try {
        parser.parse(count, words);
        options.knobs.insert(options.knobs.end(), options.named.begin(), options.named.end());
    } catch (const CLI::ParseError& error) {
        return parser.exit(error) == 0 ? 0 : 2;
    }
    try {
        run(options);
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral bench: %s\n", error.what());
        return 3;
    }
}
