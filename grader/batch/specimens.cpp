#include "batch/specimens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

std::string with_underscores(std::string text)
{
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
}

/// The unit's file that a specimen stands for: the only one, or the one with its suffix.
std::string replaced_file(const Exercise& exercise, const fs::path& specimen)
{
    std::vector<std::string> fitting;
    for (const std::string& file : exercise.files)
        if (fs::path(file).extension() == specimen.extension()) fitting.push_back(file);
    if (fitting.size() != 1)
        throw std::runtime_error(fmt::format("{}: expected exactly one file of {} with this suffix, found {}", specimen.string(), exercise.id, fitting.size()));
    return fitting.front();
}

/// The lines "// key: value" that a specimen begins with; a line without a key goes on with the value before it.
std::map<std::string, std::string> header_of(const fs::path& file)
{
    std::map<std::string, std::string> header;
    std::istringstream text(read_text(file));
    std::string key;
    for (std::string line; std::getline(text, line) && line.starts_with("//");) {
        const std::string content = line.substr(line.find_first_not_of("/ ", 0) == std::string::npos ? line.size() : line.find_first_not_of("/ ", 0));
        const std::size_t colon = content.find(": ");
        const std::string before = content.substr(0, colon);
        if (colon != std::string::npos && (before == "mistake" || before == "alternative" || before == "credit" || before == "hint" || before == "verdict")) {
            key = before;
            header[key] = content.substr(colon + 2);
        } else if (!key.empty() && !content.empty()) {
            header[key] += " " + content;
        }
    }
    return header;
}

const std::string& need(const std::map<std::string, std::string>& header, const std::string& key, const fs::path& file)
{
    const auto found = header.find(key);
    if (found == header.end()) throw std::runtime_error(fmt::format("{}: expected a line '// {}: …' at its beginning", file.string(), key));
    return found->second;
}

double number_or_nan(const std::string& text)
{
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return text.empty() || *end != 0 ? std::nan("") : number;
}

Specimen read_mistake(const fs::path& file)
{
    const auto header = header_of(file);
    Specimen specimen;
    specimen.what = need(header, "mistake", file);
    specimen.hint = need(header, "hint", file);
    const std::string& credit = need(header, "credit", file);
    const std::size_t dots = credit.find("..");
    if (dots != std::string::npos) {
        specimen.least_credit = number_or_nan(credit.substr(0, dots));
        specimen.most_credit = number_or_nan(credit.substr(dots + 2));
    }
    if (dots == std::string::npos || !(specimen.least_credit <= specimen.most_credit))
        throw std::runtime_error(fmt::format("{}: expected '// credit: LOW..HIGH' in percent, got '{}'", file.string(), credit));
    if (header.contains("verdict")) specimen.verdict = verdict_from(header.at("verdict"));
    return specimen;
}

template <class Read>
std::vector<Specimen> read_folder(const fs::path& reference, const Exercise& exercise, const char* folder, Read read)
{
    std::vector<Specimen> specimens;
    if (!fs::is_directory(exercise.folder / folder)) return specimens;
    for (const auto& entry : fs::directory_iterator(exercise.folder / folder)) {
        Specimen specimen = read(entry.path());
        specimen.name = entry.path().stem().string();
        specimen.file = entry.path();
        specimen.sources = reference_sources(reference, exercise);
        specimen.sources[replaced_file(exercise, entry.path())] = read_text(entry.path());
        specimens.push_back(std::move(specimen));
    }
    std::sort(specimens.begin(), specimens.end(), [](const Specimen& a, const Specimen& b) { return a.name < b.name; });
    return specimens;
}

}

Sources reference_sources(const fs::path& reference, const Exercise& exercise)
{
    const fs::path place = reference / exercise.topic / with_underscores(exercise.name);
    Sources sources;
    for (const std::string& file : exercise.files)
        sources[file] = read_text(exercise.files.size() == 1 && exercise.is_cpp() ? fs::path(place.string() + ".cpp") : place / file);
    return sources;
}

Sources stub_sources(const Exercise& exercise)
{
    Sources sources;
    for (const std::string& file : exercise.files) sources[file] = read_text(exercise.folder / file);
    return sources;
}

std::vector<Specimen> mistakes_of(const fs::path& reference, const Exercise& exercise) { return read_folder(reference, exercise, "mistakes", read_mistake); }

std::vector<Specimen> alternatives_of(const fs::path& reference, const Exercise& exercise)
{
    return read_folder(reference, exercise, "alternatives", [](const fs::path& file) {
        Specimen specimen;
        specimen.what = need(header_of(file), "alternative", file);
        return specimen;
    });
}

}
