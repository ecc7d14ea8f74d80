#include "collect/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "collect/file_names.hpp"

namespace umbral::grader {
namespace {

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

std::string read_text(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return text.str();
}

void write_text(const std::filesystem::path& file, std::string_view text)
{
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << text).flush())
        throw std::runtime_error(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

Sources texts_of(const Sources& files)
{
    Sources texts;
    for (const auto& [name, text] : files)
        if (kind_of(name) == FileKind::shader) texts[name] = text;
    return texts;
}

std::size_t bytes_of(const Sources& files)
{
    std::size_t bytes = 0;
    for (const auto& [name, text] : files) bytes += name.size() + text.size();
    return bytes;
}

bool is_stub(std::string_view text, const Exercise& exercise, const std::string& name)
{
    return essence(text) == essence(read_text(exercise.folder / name));
}

bool equals_stub(const Sources& files, const Exercise& exercise)
{
    return std::ranges::all_of(exercise.files, [&](const std::string& name) {
        const auto found = files.find(name);
        return found != files.end() && is_stub(found->second, exercise, name);
    });
}

}
