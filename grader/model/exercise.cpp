#include "model/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "model/digest.hpp"
#include "model/json_file.hpp"

namespace umbral::grader {
namespace {

/// The course's order of topics; others come behind.
constexpr std::array topics{"pipeline", "meshes", "transforms", "projections", "lighting", "texturing", "interaction", "raytracing"};

std::string digest_of(const Exercise& exercise)
{
    std::vector<NamedFile> files;
    for (const std::string& name : exercise.files) files.push_back({name, exercise.folder / name});
    for (const char* name : {"exercise.json", "driver.cpp"}) files.push_back({name, exercise.folder / name});
    // Headers that the driver may include: its own, its topic's, those of all topics.
    const std::filesystem::path topic = exercise.folder.parent_path();
    const std::pair<const char*, std::filesystem::path> folders[] = {{"./", exercise.folder}, {"../", topic}, {"../../", topic.parent_path()}};
    for (const auto& [where, folder] : folders)
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".hpp" && entry.is_regular_file()) files.push_back({where + entry.path().filename().string(), entry.path()});
    return sha256_of_files(std::move(files));
}

std::vector<std::filesystem::path> folders_in(const std::filesystem::path& root)
{
    std::vector<std::filesystem::path> folders;
    std::error_code loop;  // of symbolic links: no folder
    for (const auto& entry : std::filesystem::directory_iterator(root))
        if (entry.is_directory(loop)) folders.push_back(entry.path());
    return folders;
}

auto place_in_course(const Exercise& exercise)
{
    const auto topic = std::find(topics.begin(), topics.end(), exercise.topic) - topics.begin();
    return std::tuple(topic, exercise.topic, exercise.order.value_or(std::numeric_limits<double>::infinity()), exercise.id);
}

}

bool Exercise::is_cpp() const
{
    return std::any_of(files.begin(), files.end(), [](const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".hpp"); });
}

bool Exercise::counts_cost() const
{
    return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return check.judge == JudgeKind::cost; });
}

bool Exercise::has_oracle() const
{
    return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return check.hard; });
}

std::vector<std::string> Exercise::cases() const
{
    std::vector<std::string> names;
    for (const Check& check : checks)
        if (std::find(names.begin(), names.end(), check.case_name) == names.end()) names.push_back(check.case_name);
    return names;
}

Exercise load_exercise(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / "exercise.json";
    Exercise exercise = parse_exercise(read_json(file), file.string());
    exercise.folder = std::filesystem::canonical(folder);
    const std::string place = (exercise.folder.parent_path().filename() / exercise.folder.filename()).string();
    if (exercise.id != place)
        throw std::runtime_error(fmt::format("{}: id: expected \"{}\", as its folders are called, got \"{}\"", file.string(), place, exercise.id));
    exercise.digest = digest_of(exercise);
    return exercise;
}

Units load_units(const std::filesystem::path& root)
{
    if (!std::filesystem::is_directory(root))
        throw std::runtime_error(fmt::format("{}: expected a directory with units, topic/unit/exercise.json", root.string()));
    Units units;
    const auto keep_broken = [&](std::string id, const auto& load) {
        try {
            load();
        } catch (const std::exception& error) {
            units.broken.push_back({std::move(id), error.what()});
        }
    };
    for (const auto& topic : folders_in(root))
        keep_broken(topic.filename().string(), [&] {
            for (const auto& folder : folders_in(topic))
                keep_broken((topic.filename() / folder.filename()).string(), [&] {
                    if (std::filesystem::exists(folder / "exercise.json")) units.exercises.push_back(load_exercise(folder));
                });
        });
    std::ptrdiff_t noise = 0;
    for (const Exercise& exercise : units.exercises)
        noise += std::count_if(exercise.checks.begin(), exercise.checks.end(), [](const Check& check) { return check.judge == JudgeKind::noise; });
    if (noise > most_noise_checks)
        throw std::runtime_error(fmt::format("{}: expected at most {} checks of the judge \"noise\" in all units, which share one budget of errors, got {}",
                                             root.string(), most_noise_checks, noise));
    std::ranges::sort(units.exercises, {}, place_in_course);
    std::ranges::sort(units.broken, {}, &BrokenUnit::id);
    return units;
}

const char* to_string(JudgeKind kind)
{
    switch (kind) {
        case JudgeKind::numbers: return "numbers";
        case JudgeKind::matrices: return "matrices";
        case JudgeKind::buffer: return "buffer";
        case JudgeKind::image: return "image";
        case JudgeKind::fragments: return "fragments";
        case JudgeKind::trace: return "trace";
        case JudgeKind::events: return "events";
        case JudgeKind::cost: return "cost";
        case JudgeKind::noise: return "noise";
    }
    throw std::invalid_argument("judge: expected one of the declared ones, got number " + std::to_string(static_cast<int>(kind)));
}

}
