#include "build/offered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "build/forbidden.hpp"
#include "build/framework_headers.hpp"
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

/// "umbral/raytracing/shadows.hpp" of its real path; empty if it is none of the framework's headers, whose `folder`
/// ends in a slash.
std::string header_within(std::string_view folder, std::string_view path)
{
    return path.starts_with(folder) ? std::string(path.substr(folder.size())) : "";
}

}

Offered offered_to(const Toolchain& tools, const Exercise& exercise)
{
    Offered offered;
    offered.framework = fs::weakly_canonical(tools.framework);
    add_lines(tools.units / "framework-exports.txt", offered.symbols);
    for (const std::string& used : exercise.uses) add_lines(unit_folder(tools, used) / "exports.txt", offered.symbols);
    std::vector<std::string> interfaces = exercise.interfaces;
    interfaces.insert(interfaces.end(), exercise.used_interfaces.begin(), exercise.used_interfaces.end());
    offered.headers = with_included(tools.framework, std::move(interfaces));
    return offered;
}

std::optional<std::string> find_of_other_units(const Inspection& inspection, const Offered& offered)
{
    const std::string folder = (offered.framework / "").lexically_normal().string();
    for (const InspectedFunction& function : inspection.functions) {
        const std::string header = header_within(folder, function.file);
        const auto holds = [&](std::string_view start) { return header.starts_with(start); };
        if (header.empty() || std::ranges::any_of(common, holds) || offered.headers.contains(header)) continue;
        return fmt::format("{} of <{}> is not allowed in this unit: it belongs to other units",
                           one_line(qualified_name(function.name)), one_line(header));
    }
    return std::nullopt;
}

}
