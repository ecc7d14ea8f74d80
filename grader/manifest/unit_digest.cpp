#include "manifest/unit_digest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "manifest/include_lines.hpp"
#include "model/digest.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Files of the project by their names in it, with all that they include.
class Closure {
public:
    explicit Closure(fs::path project) : project_(std::move(project)) {}

    void add(const fs::path& file)
    {
        const std::string name = file.lexically_normal().lexically_relative(project_).string();
        if (!files_.emplace(name, file).second) return;
        std::ifstream stream(file);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (const std::string& other : included_in(text)) add_included(file, other);
    }

    [[nodiscard]] std::vector<NamedFile> files() const
    {
        std::vector<NamedFile> list;
        for (const auto& [name, path] : files_) list.push_back({name, path});
        return list;
    }

private:
    void add_included(const fs::path& from, const std::string& name)
    {
        for (const fs::path& folder :
             {from.parent_path(), project_ / "exercises", project_ / "framework", project_ / "reference"})
            if (const fs::path file = folder / name; fs::is_regular_file(file)) return add(file);
    }

    fs::path project_;
    std::map<std::string, fs::path> files_;
};

std::string packaged_digest(const fs::path& file)
try {
    return read_json(file).at("digest").get<std::string>();
} catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}; install the package again", file.string(), error.what()));
}

}

std::string unit_digest(const Exercise& exercise)
{
    const fs::path packaged = exercise.folder / packaged_file;
    if (!fs::exists(exercise.folder / "driver.cpp") && fs::exists(packaged)) return packaged_digest(packaged);
    const fs::path project = exercise.folder.parent_path().parent_path().parent_path();
    Closure closure(project);
    for (const char* const name : {"exercise.json", "driver.cpp"}) closure.add(exercise.folder / name);
    for (const std::string& name : exercise.files) closure.add(exercise.folder / name);
    std::string unit = exercise.name;
    std::ranges::replace(unit, '-', '_');
    const fs::path reference = project / "reference" / exercise.topic;
    for (const std::string& name : {unit + ".cpp", unit + "_oracle.cpp"})
        if (fs::is_regular_file(reference / name)) closure.add(reference / name);
    for (const std::string& name : exercise.files)
        if (fs::is_regular_file(reference / name)) closure.add(reference / name);
    return sha256_of_files(closure.files());
}

}
