#include "worker/packaged_unit.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "model/digest.hpp"
#include "model/recording.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Veils bytes, and lifts the veil: each of them and one of a stream that follows from their name.
std::string veiled(std::string text, const std::string& name)
{
    std::string stream;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i % 64 == 0) stream = sha256_hex(fmt::format("umbral-veil-1 {} {}", name, i));
        text[i] = static_cast<char>(text[i] ^ stream[i % 64] ^ static_cast<char>(0x80));
    }
    return text;
}

fs::path shaders_file(const Toolchain& tools, const Exercise& exercise)
{
    return unit_folder(tools, exercise.id) / "shaders";
}

/// {"reference": {FILE: TEXT}, "mistakes": {NAME: {FILE: TEXT}}}; nothing of units in C++.
json packaged_shaders(const Toolchain& tools, const Exercise& exercise)
{
    if (exercise.is_cpp()) return {{"reference", json::object()}, {"mistakes", json::object()}};
    const fs::path file = shaders_file(tools, exercise);
    return parse_json(veiled(read_text(file), exercise.id), file.string());
}

/// Throws with the file's name if the JSON lacks what it must hold: then the package is damaged.
template <class Read>
auto read_packaged(const fs::path& file, Read read)
try {
    return read();
} catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}; install the package again", file.string(), error.what()));
}

}

void write_packaged(const fs::path& reference, const Exercise& exercise, const fs::path& folder)
{
    json mistakes = json::array();
    json shaders = {{"reference", json::object()}, {"mistakes", json::object()}};
    if (!exercise.is_cpp()) shaders["reference"] = texts_of(reference_sources(reference, exercise));
    for (const KnownSolution& mistake : mistakes_of(reference, exercise)) {
        json one = {{"name", mistake.name}, {"mistake", mistake.what}, {"hint", mistake.hint}};
        if (mistake.verdict) one["verdict"] = to_string(*mistake.verdict);
        mistakes.push_back(std::move(one));
        if (!exercise.is_cpp()) shaders["mistakes"][mistake.name] = texts_of(mistake.sources);
    }
    fs::create_directories(folder);
    write_text(
        folder / packaged_file,
        json{{"format", "umbral-packaged-unit"}, {"version", 1}, {"digest", exercise.digest}, {"mistakes", mistakes}}
                .dump(1) +
            "\n");
    if (!exercise.is_cpp()) write_text(folder / "shaders", veiled(shaders.dump(), exercise.id));
}

void veil_libraries(const fs::path& units)
{
    std::vector<fs::path> libraries;
    for (const auto& entry : fs::recursive_directory_iterator(units))
        if (entry.path().extension() == ".so" && entry.path().filename() != "driver.so")
            libraries.push_back(entry.path());
    for (const fs::path& library : libraries) {
        const std::string name = fs::relative(library, units).replace_extension().string();
        write_text(fs::path(library).replace_extension(".veiled"), veiled(read_text(library), name));
        fs::remove(library);
    }
}

bool is_veiled(const Toolchain& tools, const Exercise& exercise, const std::string& name)
{
    const fs::path folder = unit_folder(tools, exercise.id);
    return !fs::exists(folder / (name + ".so")) && fs::exists(folder / (name + ".veiled"));
}

fs::path answer_library(const Toolchain& tools, const Exercise& exercise, const std::string& name,
                        const fs::path& scratch)
{
    if (!is_veiled(tools, exercise, name)) return unit_folder(tools, exercise.id) / (name + ".so");
    const fs::path kept = unit_folder(tools, exercise.id) / (name + ".veiled");
    const fs::path unveiled = scratch / exercise.id / (name + ".so");
    if (fs::exists(unveiled)) return unveiled;
    fs::create_directories(unveiled.parent_path());
    write_text(unveiled, veiled(read_text(kept), exercise.id + "/" + name));
    return unveiled;
}

std::vector<KnownSolution> known_mistakes(const Toolchain& tools, const Exercise& exercise)
{
    const fs::path file = exercise.folder / packaged_file;
    if (fs::is_directory(tools.reference) || !fs::exists(file)) return mistakes_of(tools.reference, exercise);
    return read_packaged(file, [&] {
        const json unit = read_json(file);
        const json shaders = packaged_shaders(tools, exercise);
        std::vector<KnownSolution> mistakes;
        for (const json& one : unit.at("mistakes")) {
            KnownSolution mistake;
            mistake.name = one.at("name").get<std::string>();
            mistake.what = one.at("mistake").get<std::string>();
            mistake.hint = one.at("hint").get<std::string>();
            if (one.contains("verdict")) mistake.verdict = verdict_from(one.at("verdict").get<std::string>());
            if (!exercise.is_cpp())
                for (const auto& [name, text] : shaders.at("mistakes").at(mistake.name).items())
                    mistake.sources[name] = text.get<std::string>();
            mistakes.push_back(std::move(mistake));
        }
        return mistakes;
    });
}

Sources reference_shaders(const Toolchain& tools, const Exercise& exercise)
{
    if (exercise.is_cpp()) return {};
    if (fs::is_directory(tools.reference)) return reference_sources(tools.reference, exercise);
    const fs::path file = shaders_file(tools, exercise);
    return read_packaged(file, [&] {
        Sources sources;
        const json shaders = packaged_shaders(tools, exercise);
        for (const auto& [name, text] : shaders.at("reference").items()) sources[name] = text.get<std::string>();
        return sources;
    });
}

}
