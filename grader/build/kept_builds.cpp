#include "build/kept_builds.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "model/scratch.hpp"

namespace umbral::grader {

namespace fs = std::filesystem;

std::optional<Built> kept(const fs::path& folder)
{
    std::ifstream stream(folder / "result.json");
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    Built built;
    try {
        built.verdict = verdict_from(json.at("verdict").get<std::string>());
        built.message = json.at("message").get<std::string>();
        built.compile_seconds = json.at("compile_seconds").get<double>();
        built.keeps_nothing = json.at("keeps_nothing").get<bool>();
        if (built.verdict != Verdict::ok) return built;
        built.library = folder / "student.so";
        std::error_code missing;
        if (fs::file_size(built.library, missing) == json.at("bytes").get<std::uintmax_t>() && !missing) return built;
    } catch (const nlohmann::json::exception&) {
    } catch (const std::invalid_argument&) {
    }
    return std::nullopt;
}

Built keep(const Built& built, const fs::path& work, const fs::path& folder)
{
    for (const auto& entry : fs::directory_iterator(work))
        if (entry.path().filename() != "student.so") fs::remove_all(entry.path());
    nlohmann::json json = {{"verdict", to_string(built.verdict)},
                           {"message", built.message},
                           {"compile_seconds", built.compile_seconds},
                           {"keeps_nothing", built.keeps_nothing}};
    if (built.verdict == Verdict::ok) json["bytes"] = fs::file_size(work / "student.so");
    std::ofstream(work / "result.json") << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    fs::create_directories(folder.parent_path());
    std::error_code taken;
    fs::rename(work, folder, taken);
    if (const auto result = kept(folder)) return *result;
    // What lies there is damaged: out of the way in one step, for others may be looking.
    const ScratchFolder damaged(work.parent_path());
    std::error_code ignored;
    fs::rename(folder, damaged.path() / "entry", ignored);
    fs::rename(work, folder, taken);
    if (const auto result = kept(folder)) return *result;
    throw std::runtime_error(
        fmt::format("cannot keep a build in {}: {}; is the disk full?", folder.string(), taken.message()));
}

}
