#include "manifest/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "judge/judges.hpp"
#include "manifest/statement_table.hpp"
#include "manifest/unit_digest.hpp"
#include "model/include_lines.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

/// The course's order of topics, from `root`/topics.txt; none if there is no such file.
std::vector<std::string> topics_in_order(const std::filesystem::path& root)
{
    std::vector<std::string> topics;
    std::ifstream stream(root / "topics.txt");
    for (std::string line; std::getline(stream, line);)
        if (!line.empty() && !line.starts_with('#')) topics.push_back(line);
    return topics;
}

std::vector<std::filesystem::path> folders_in(const std::filesystem::path& root)
{
    std::vector<std::filesystem::path> folders;
    std::error_code loop;  // of symbolic links: no folder
    for (const auto& entry : std::filesystem::directory_iterator(root))
        if (entry.is_directory(loop)) folders.push_back(entry.path());
    return folders;
}

auto place_in_course(const Exercise& exercise, const std::vector<std::string>& topics)
{
    const auto topic = std::ranges::find(topics, exercise.topic) - topics.begin();
    return std::tuple(topic, exercise.topic, exercise.order.value_or(std::numeric_limits<double>::infinity()),
                      exercise.id);
}

/// Adds the headers of the framework that stubs include, each once; a stub that is missing includes none.
void add_included(const std::filesystem::path& folder, const std::vector<std::string>& stubs,
                  std::vector<std::string>& all)
{
    for (const std::string& stub : stubs) {
        std::ifstream stream(folder / stub);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (const std::string& header : framework_includes(text))
            if (std::ranges::find(all, header) == all.end()) all.push_back(header);
    }
}

/// The headers of the units that a unit may call. One that is missing, or broken, is told by itself.
std::vector<std::string> included_by_used(const Exercise& exercise)
{
    std::vector<std::string> all;
    for (const std::string& used : exercise.uses) {
        const std::filesystem::path folder = exercise.folder.parent_path().parent_path() / used;
        try {
            const nlohmann::json manifest = read_json(folder / "exercise.json");
            add_included(folder, manifest.at("files").get<std::vector<std::string>>(), all);
        } catch (const std::exception&) {
            continue;
        }
    }
    return all;
}

/// What its statement says of each check; a unit without a statement is for validate to refuse.
void add_statement(Exercise& exercise)
{
    std::ifstream stream(exercise.folder / "README.md");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::vector<StatementLine> lines = statement_lines(text);
    for (Check& check : exercise.checks) check.about = statement_says(lines, check.case_name, check.value);
}

Exercise load_with(const std::filesystem::path& folder, ProjectSources& sources)
{
    const std::filesystem::path file = folder / "exercise.json";
    Exercise exercise = parse_exercise(read_json(file), file.string());
    exercise.folder = std::filesystem::canonical(folder);
    const std::string place = (exercise.folder.parent_path().filename() / exercise.folder.filename()).string();
    if (exercise.id != place)
        throw std::runtime_error(fmt::format("{}: id: expected \"{}\", as its folders are called, got \"{}\"",
                                             file.string(), place, exercise.id));
    add_included(exercise.folder, exercise.files, exercise.interfaces);
    exercise.used_interfaces = included_by_used(exercise);
    add_statement(exercise);
    exercise.digest = unit_digest(exercise, sources);
    return exercise;
}

}

Exercise load_exercise(const std::filesystem::path& folder)
{
    ProjectSources sources;
    return load_with(folder, sources);
}

Units load_units(const std::filesystem::path& root)
{
    if (!std::filesystem::is_directory(root))
        throw std::runtime_error(
            fmt::format("{}: expected a directory with units, topic/unit/exercise.json", root.string()));
    Units units;
    ProjectSources sources;
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
                    if (std::filesystem::exists(folder / "exercise.json"))
                        units.exercises.push_back(load_with(folder, sources));
                });
        });
    for (const JudgeRecord* record : judges()) {
        std::ptrdiff_t count = 0;
        for (const Exercise& exercise : units.exercises)
            count +=
                std::ranges::count(exercise.checks, record->name, [](const Check& check) { return check.judge.name; });
        if (record->most_in_course > 0 && count > record->most_in_course)
            throw std::runtime_error(
                fmt::format("{}: expected at most {} checks of the judge \"{}\" in all units, which share one budget "
                            "of errors, got {}",
                            root.string(), record->most_in_course, record->name, count));
    }
    const std::vector<std::string> topics = topics_in_order(root);
    std::ranges::sort(units.exercises, {}, [&](const Exercise& exercise) { return place_in_course(exercise, topics); });
    std::ranges::sort(units.broken, {}, &BrokenUnit::id);
    return units;
}

}
