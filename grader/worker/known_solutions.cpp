#include "worker/known_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "model/change.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

using Header = std::map<std::string, std::string>;

constexpr const char* change_suffix = ".change";

std::string with_underscores(std::string text)
{
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
}

/// The unit's file that a solution stands for: the one it names, the only one with its suffix, or the only one.
std::string replaced_file(const Exercise& exercise, const fs::path& solution, const Header& header)
{
    const bool change = solution.extension() == change_suffix;
    std::vector<std::string> fitting;
    for (const std::string& file : exercise.files)
        if (header.contains("file") ? header.at("file") == file
                                    : change || fs::path(file).extension() == solution.extension())
            fitting.push_back(file);
    if (fitting.size() != 1)
        throw std::runtime_error(
            fmt::format("{}: expected exactly one file of {} that it stands for, found {}; name it as 'file: NAME'",
                        solution.string(), exercise.id, fitting.size()));
    return fitting.front();
}

const std::string& need(const Header& header, const std::string& key, const fs::path& file)
{
    const auto found = header.find(key);
    if (found == header.end())
        throw std::runtime_error(fmt::format("{}: expected a line '{}: …' at its beginning", file.string(), key));
    return found->second;
}

double number_or_nan(const std::string& text)
{
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return text.empty() || *end != 0 ? std::nan("") : number;
}

/// The line of the unit's rubric that a mistake breaks, from 0 on; in the file they are counted from 1.
std::size_t broken_line(const Exercise& exercise, const fs::path& file, const std::string& number)
{
    for (std::size_t i = 0; i < exercise.rubric.size(); ++i)
        if (number == std::to_string(i + 1)) return i;
    throw std::runtime_error(fmt::format(
        "{}: expected 'rubric: N' with a line of the rubric in exercise.json, which has {} of them, got '{}'",
        file.string(), exercise.rubric.size(), number));
}

KnownSolution read_mistake(const Exercise& exercise, const fs::path& file, const Header& header)
{
    KnownSolution solution;
    solution.what = need(header, "mistake", file);
    solution.hint = need(header, "hint", file);
    const std::string& credit = need(header, "credit", file);
    const std::size_t dots = credit.find("..");
    if (dots != std::string::npos) {
        solution.least_credit = number_or_nan(credit.substr(0, dots));
        solution.most_credit = number_or_nan(credit.substr(dots + 2));
    }
    if (dots == std::string::npos || !(solution.least_credit <= solution.most_credit))
        throw std::runtime_error(
            fmt::format("{}: expected 'credit: LOW..HIGH' in percent, got '{}'", file.string(), credit));
    if (header.contains("verdict")) solution.verdict = verdict_from(header.at("verdict"));
    if (header.contains("rubric")) solution.rubric_line = broken_line(exercise, file, header.at("rubric"));
    return solution;
}

std::string changed(const std::string& text, const Header& header, const std::string& reference,
                    const Exercise& exercise, const fs::path& file)
{
    const auto from = header.find("from");
    return apply_change(parse_change(text, file.string()),
                        from == header.end() ? reference : read_text(exercise.folder / from->second), file.string());
}

template <class Read>
std::vector<KnownSolution> read_folder(const fs::path& reference, const Exercise& exercise, const char* folder,
                                       Read read)
{
    std::vector<KnownSolution> solutions;
    if (!fs::is_directory(exercise.folder / folder)) return solutions;
    for (const auto& entry : fs::directory_iterator(exercise.folder / folder)) {
        const std::string text = read_text(entry.path());
        const Header header = solution_header(text);
        if (header.contains("knob") && (!exercise.knob || exercise.knob->name != header.at("knob")))
            throw std::runtime_error(fmt::format("{}: expected no 'knob: {}', since exercise.json has {}",
                                                 entry.path().string(), header.at("knob"),
                                                 exercise.knob ? "the knob " + exercise.knob->name : "none"));
        KnownSolution solution = read(entry.path(), header);
        solution.name = entry.path().stem().string();
        solution.file = entry.path();
        solution.sources = reference_sources(reference, exercise);
        std::string& replaced = solution.sources.at(replaced_file(exercise, entry.path(), header));
        replaced =
            entry.path().extension() == change_suffix ? changed(text, header, replaced, exercise, entry.path()) : text;
        solutions.push_back(std::move(solution));
    }
    std::sort(solutions.begin(), solutions.end(),
              [](const KnownSolution& a, const KnownSolution& b) { return a.name < b.name; });
    return solutions;
}

}

std::map<std::string, fs::path> reference_files(const fs::path& reference, const Exercise& exercise)
{
    const fs::path place = reference / exercise.topic / with_underscores(exercise.name);
    std::map<std::string, fs::path> files;
    for (const std::string& file : exercise.files)
        files[file] =
            exercise.files.size() == 1 && exercise.is_cpp() ? fs::path(place.string() + ".cpp") : place / file;
    return files;
}

Sources reference_sources(const fs::path& reference, const Exercise& exercise)
{
    Sources sources;
    for (const auto& [file, path] : reference_files(reference, exercise)) sources[file] = read_text(path);
    return sources;
}

Sources stub_sources(const Exercise& exercise)
{
    Sources sources;
    for (const std::string& file : exercise.files) sources[file] = read_text(exercise.folder / file);
    return sources;
}

std::vector<KnownSolution> mistakes_of(const fs::path& reference, const Exercise& exercise)
{
    return read_folder(reference, exercise, "mistakes", [&](const fs::path& file, const Header& header) {
        return read_mistake(exercise, file, header);
    });
}

std::vector<KnownSolution> alternatives_of(const fs::path& reference, const Exercise& exercise)
{
    return read_folder(reference, exercise, "alternatives", [](const fs::path& file, const Header& header) {
        KnownSolution solution;
        solution.what = need(header, "alternative", file);
        return solution;
    });
}

Built as_built(const KnownSolution& mistake)
{
    Built built;
    built.verdict = Verdict::ok;
    built.sources = texts_of(mistake.sources);
    built.mistake = mistake.name;
    return built;
}

}
