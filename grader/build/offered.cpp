#include "build/offered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "build/forbidden.hpp"
#include "collect/sources.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Headers of no unit, which all may use.
constexpr std::array<std::string_view, 5> common{"umbral/core/", "umbral/gl/", "umbral/input/", "umbral/record/",
                                                 "umbral/student.hpp"};

void add_lines(const fs::path& file, std::set<std::string>& lines)
{
    std::istringstream text(read_text(file));
    for (std::string line; std::getline(text, line);) lines.insert(line);
}

/// Adds a header, and what it includes of the framework's.
void add_header(const fs::path& framework, const std::string& header, std::set<std::string>& headers)
{
    if (!headers.insert(header).second) return;
    std::istringstream text(read_text(framework / header));
    constexpr std::string_view directive = "#include <";
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with(directive)) continue;
        const std::string name = line.substr(directive.size(), line.find('>') - directive.size());
        if (name.starts_with("umbral/")) add_header(framework, name, headers);
    }
}

/// "umbral/raytracing/shadows.hpp" of a path to it; empty if it is none of the framework's headers.
std::string header_within(const fs::path& framework, const std::string& path)
{
    const std::string folder = (framework / "").lexically_normal().string();
    const std::string plain = fs::path(path).lexically_normal().string();
    return plain.starts_with(folder) ? plain.substr(folder.size()) : "";
}

}

Offered offered_to(const Toolchain& tools, const Exercise& exercise)
{
    Offered offered;
    offered.framework = tools.framework;
    add_lines(tools.units / "framework-exports.txt", offered.symbols);
    for (const std::string& used : exercise.uses) add_lines(unit_folder(tools, used) / "exports.txt", offered.symbols);
    for (const auto* interfaces : {&exercise.interfaces, &exercise.used_interfaces})
        for (const std::string& header : *interfaces) add_header(tools.framework, header, offered.headers);
    return offered;
}

std::optional<std::string> find_of_other_units(const Inspection& inspection, const Offered& offered)
{
    for (const InspectedFunction& function : inspection.functions) {
        const std::string header = header_within(offered.framework, function.file);
        const auto holds = [&](std::string_view folder) { return header.starts_with(folder); };
        if (header.empty() || std::ranges::any_of(common, holds) || offered.headers.contains(header)) continue;
        return fmt::format("{} of <{}> is not allowed in this unit: it belongs to other units",
                           one_line(qualified_name(function.name)), one_line(header));
    }
    return std::nullopt;
}

}
