#include "build/submission.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "run/descriptor.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::array suffixes = {".cpp", ".hpp", ".glsl", ".vert", ".frag", ".geom", ".comp"};

bool is_source(const fs::path& file)
{
    const std::string suffix = file.extension().string();
    return std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end() && is_submission_id(file.filename().string());
}

/// Reads one handed-in file into `handed`; refuses what is not a plain file of reasonable size.
void read_handed(const fs::path& path, Handed& handed)
{
    const std::string name = path.filename().string();
    const auto refuse = [&](const std::string& reason) { handed.refused = fmt::format("{}: {}", name, reason); };
    // Without O_NONBLOCK, opening a pipe that somebody planted would wait for ever.
    const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!file) return refuse("it cannot be read, or is a link: hand in the file itself");
    if (fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return refuse("it is not a regular file");
    if (static_cast<std::size_t>(status.st_size) > largest_file)
        return refuse(fmt::format("it has {} bytes; at most {} are read", status.st_size, largest_file));
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t got = pread(file.get(), text.data() + size, text.size() - size, static_cast<off_t>(size));
        if (got <= 0) break;
        size += static_cast<std::size_t>(got);
    }
    text.resize(size);
    handed.files[name] = std::move(text);
}

/// A text without comments and white space, for comparing with a stub.
std::string essence(std::string_view text)
{
    std::string kept;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
        } else {
            if (std::string_view(" \t\r\n\f\v").find(text[i]) == std::string_view::npos) kept += text[i];
            ++i;
        }
    }
    return kept;
}

}

bool is_submission_id(std::string_view name)
{
    const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-'; };
    return !name.empty() && name.size() <= 128 && name != "." && name != ".." && std::all_of(name.begin(), name.end(), plain);
}

std::string read_text(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return text.str();
}

Handed collect(const fs::path& folder, const Exercise& exercise)
{
    Handed handed;
    const fs::path own = folder / exercise.topic / exercise.name;
    const bool workspace = fs::is_directory(fs::symlink_status(own)) && fs::is_directory(fs::symlink_status(folder / exercise.topic));
    const fs::path place = workspace ? own : folder;
    std::set<fs::path> paths;
    for (const std::string& name : exercise.files)
        if (fs::exists(fs::symlink_status(place / name)))
            paths.insert(place / name);
        else
            handed.missing.push_back(name);
    // A student's own helpers: in a flat submission they could belong to any unit, so only C++ headers and sources beside the unit count.
    if (workspace) {
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(own, ignored))
            if (is_source(entry.path()) && paths.size() < most_files) paths.insert(entry.path());
    }
    for (const fs::path& path : paths) read_handed(path, handed);
    return handed;
}

Sources texts_of(const Sources& files)
{
    Sources texts;
    for (const auto& [name, text] : files)
        if (!name.ends_with(".cpp") && !name.ends_with(".hpp")) texts[name] = text;
    return texts;
}

bool equals_stub(const Sources& files, const Exercise& exercise)
{
    return std::all_of(exercise.files.begin(), exercise.files.end(), [&](const std::string& name) {
        const auto found = files.find(name);
        return found != files.end() && essence(found->second) == essence(read_text(exercise.folder / name));
    });
}

}
