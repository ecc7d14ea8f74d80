#include "build/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "build/real_paths.hpp"
#include "run/confine.hpp"

namespace umbral::grader {
namespace {

/// Processor time of one look at places: a student's library takes hundredths of a second.
constexpr double most_place_seconds = 2;

ConfinedResult run_inspector(const Toolchain& tools, const std::filesystem::path& library,
                             const std::vector<std::string>& arguments, double seconds = 10,
                             std::vector<std::string> also_read = {})
{
    ConfinedCommand command;
    command.confine = tools.programs / "umbral-confine";
    command.arguments = {(tools.programs / "umbral-inspect").string()};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    command.directory = library.parent_path();
    command.read = std::move(also_read);
    command.cpu_seconds = seconds;
    command.memory_mib = 1024;
    command.output_limit = std::size_t{64} << 20U;
    ConfinedResult result = run_confined(command);
    if (tools.budget) tools.budget->take(result.cpu_seconds);
    return result;
}

}

std::optional<Inspection> inspect(const Toolchain& tools, const std::filesystem::path& library,
                                  const std::filesystem::path& interface_names)
{
    const ConfinedResult result = run_inspector(tools, library, {"names", library.string(), interface_names.string()},
                                                10, {interface_names.string()});
    if (result.exit_status == confinement_failed)
        throw std::runtime_error(fmt::format("umbral-inspect cannot be run: {}", result.output));
    if (result.exit_status != 0) return std::nullopt;
    const nlohmann::json json = nlohmann::json::parse(result.output, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    Inspection inspection;
    inspection.missing = json.at("missing");
    for (const auto& pair : json.at("undefined")) inspection.undefined.push_back({pair.at(0), pair.at(1)});
    RealPaths paths;
    for (const auto& one : json.at("functions"))
        inspection.functions.push_back({one.at(0), paths.of(one.at(1)), one.at(2), one.at(3), one.at(4)});
    if (paths.too_many()) return std::nullopt;
    inspection.uncounted = json.at("uncounted");
    inspection.own_memory = json.at("own_memory");
    return inspection;
}

std::string place_of(const Toolchain& tools, const std::filesystem::path& library,
                     const std::vector<std::uint64_t>& frames)
{
    std::vector<std::string> arguments{"lines", library.string()};
    for (const std::uint64_t frame : frames) arguments.push_back(std::to_string(frame));
    const ConfinedResult result = run_inspector(tools, library, arguments);
    if (result.exit_status != 0) return "";
    return result.output.substr(0, result.output.find('\n'));
}

namespace {

/// Of "sphere.cpp:17:9", whose name may hold any letter.
std::optional<SourcePlace> read_place(std::string_view text)
{
    const auto cut_number = [&]() -> std::optional<int> {
        const std::size_t colon = text.rfind(':');
        if (colon == std::string_view::npos) return std::nullopt;
        int number = 0;
        const auto [end, error] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
        if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
        text = text.substr(0, colon);
        return number;
    };
    const auto column = cut_number();
    const auto line = column ? cut_number() : std::nullopt;
    if (!line) return std::nullopt;
    return SourcePlace{std::string(text), *line, *column};
}

}

std::vector<std::optional<SourcePlace>> places_of(const Toolchain& tools, const std::filesystem::path& library,
                                                  std::span<const std::uint32_t> addresses)
{
    std::vector<std::string> arguments{"places", library.string()};
    for (const std::uint32_t address : addresses) arguments.push_back(std::to_string(address));
    const double left = tools.budget ? tools.budget->left() : std::numeric_limits<double>::infinity();
    const ConfinedResult result = run_inspector(tools, library, arguments, std::min(left, most_place_seconds));
    if (result.exit_status != 0) return {};
    std::vector<std::optional<SourcePlace>> places;
    std::string_view rest = result.output;
    for (std::size_t i = 0; i < addresses.size(); ++i) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        places.push_back(read_place(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return places;
}

}
