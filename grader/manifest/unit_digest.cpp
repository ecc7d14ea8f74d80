#include "manifest/unit_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/digest.hpp"
#include "model/include_lines.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// A file and all that it includes, by their normal paths.
void add_closure(const fs::path& project, const fs::path& file, ProjectSources& sources,
                 std::map<fs::path, std::string>& all)
{
    if (all.contains(file)) return;
    const ProjectSources::Source& source = sources.read(project, file);
    all.emplace(file, source.digest);
    for (const fs::path& other : source.including) add_closure(project, other, sources, all);
}

std::string packaged_digest(const fs::path& file)
try {
    return read_json(file).at("digest").get<std::string>();
} catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}; install the package again", file.string(), error.what()));
}

}

const ProjectSources::Source& ProjectSources::read(const fs::path& project, const fs::path& file)
{
    if (const auto known = read_.find(file); known != read_.end()) return known->second;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !fs::is_regular_file(file))
        throw std::runtime_error(fmt::format("{}: expected a readable regular file", file.string()));
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    Source source{sha256_hex(text), {}};
    for (const std::string& name : included_in(text))
        for (const fs::path& folder :
             {file.parent_path(), project / "exercises", project / "framework", project / "reference"})
            if (const fs::path other = folder / name; fs::is_regular_file(other)) {
                source.including.push_back(other.lexically_normal());
                break;
            }
    return read_.emplace(file, std::move(source)).first->second;
}

std::string unit_digest(const Exercise& exercise, ProjectSources& sources)
{
    const fs::path packaged = exercise.folder / packaged_file;
    if (!fs::exists(exercise.folder / "driver.cpp") && fs::exists(packaged)) return packaged_digest(packaged);
    const fs::path project = exercise.folder.parent_path().parent_path().parent_path();
    std::map<fs::path, std::string> files;
    const auto add = [&](const fs::path& file) { add_closure(project, file, sources, files); };
    for (const char* const name : {"exercise.json", "driver.cpp"}) add(exercise.folder / name);
    for (const std::string& name : exercise.files) add(exercise.folder / name);
    std::string unit = exercise.name;
    std::ranges::replace(unit, '-', '_');
    const fs::path reference = project / "reference" / exercise.topic;
    for (const std::string& name : {unit + ".cpp", unit + "_oracle.cpp"})
        if (fs::is_regular_file(reference / name)) add(reference / name);
    for (const std::string& name : exercise.files)
        if (fs::is_regular_file(reference / name)) add(reference / name);
    Sha256 hash;
    hash.update_field("umbral-unit-2");
    for (const auto& [path, digest] : files) {
        hash.update_field(path.lexically_relative(project).string());
        hash.update_field(digest);
    }
    return hash.finish();
}

}
