#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "judge/events/events.hpp"

namespace umbral::grader {
namespace {

std::size_t significant(std::span<const double> event)
{
    std::size_t size = event.size();
    while (size > 1 && event[size - 1] == 0) --size;
    return size;
}

}

std::map<double, std::string> event_names(std::string_view lines)
{
    std::map<double, std::string> names;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
        double code = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), code);
        const auto used = static_cast<std::size_t>(end - line.data());
        if (error == std::errc() && used + 1 < line.size() && line[used] == ' ') names[code] = line.substr(used + 1);
    }
    return names;
}

std::map<double, NamedRows> event_kinds(std::string_view lines, std::size_t components)
{
    std::map<double, NamedRows> kinds;
    for (const auto& [code, name] : event_names(lines)) {
        const std::size_t colon = std::min(name.find(": "), name.size());
        NamedRows& kind = kinds[code] = {name.substr(0, colon)};
        if (colon == name.size() || components == 0) continue;
        kind.columns.emplace_back("the kind of event");
        std::ranges::move(column_names(std::string_view(name).substr(colon + 2), components - 1, ""),
                          std::back_inserter(kind.columns));
        if (kind.columns.size() != components) kind.columns.clear();
    }
    return kinds;
}

std::vector<std::string> event_columns(std::string_view names, std::size_t components)
{
    std::vector<std::string> all;
    for (const auto& [code, kind] : event_kinds(names, components)) {
        if (kind.columns.empty()) continue;
        if (!all.empty() && kind.columns != all) return {};
        all = kind.columns;
    }
    return all;
}

EventWriter::EventWriter(const TensorView& expected, std::string_view names)
{
    for (auto& [code, name] : event_names(names)) {
        const std::size_t colon = name.find(": ");
        Kind& kind = kinds_[code] = {name, {}};
        if (colon == std::string::npos || expected.components() == 0) continue;
        kind.columns = column_groups(std::string_view(name).substr(colon + 2), expected.components() - 1);
        if (!kind.columns.empty()) kind.name.resize(colon);
    }
    for (std::size_t i = 0; i < expected.cells(); ++i)
        used_[expected.cell(i)[0]] = std::max(used_[expected.cell(i)[0]], significant(expected.cell(i)));
}

std::vector<std::string> EventWriter::parts(std::span<const double> event, int digits) const
{
    std::vector<std::string> all;
    const auto kind = kinds_.find(event[0]);
    if (kind != kinds_.end() && !kind->second.columns.empty()) {
        for (const ColumnGroup& group : kind->second.columns) {
            std::string& text = all.emplace_back(group.name);
            for (std::size_t i = 0; i < group.size; ++i) text += " " + number_text(event[1 + group.first + i], digits);
        }
        return all;
    }
    const auto used = used_.find(event[0]);
    const std::size_t size = std::max(significant(event), used == used_.end() ? 1 : used->second);
    for (std::size_t i = 1; i < size; ++i) all.push_back(number_text(event[i], digits));
    return all;
}

std::string EventWriter::with_parts(std::span<const double> event, const std::vector<std::string>& parts) const
{
    const auto kind = kinds_.find(event[0]);
    const std::string name =
        kind != kinds_.end() ? kind->second.name : fmt::format("event of code {}", number_text(event[0]));
    return parts.empty() ? name : fmt::format("{} ({})", name, fmt::join(parts, ", "));
}

std::string EventWriter::operator()(std::span<const double> event, int digits) const
{
    if (!std::isfinite(event[0])) return "an event whose code is no number";
    return with_parts(event, parts(event, digits));
}

std::pair<std::string, std::string> EventWriter::beside(std::span<const double> one, std::span<const double> other,
                                                        int digits) const
{
    constexpr std::size_t few = 4;
    const auto kind = kinds_.find(one[0]);
    const bool has_names = kind != kinds_.end() && kind->second.columns.size() > few;
    if (!has_names || one[0] != other[0]) return {(*this)(one, digits), (*this)(other, digits)};
    const std::vector<std::string> mine = parts(one, digits);
    const std::vector<std::string> its = parts(other, digits);
    std::vector<std::string> shown_mine;
    std::vector<std::string> shown_its;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const bool is_left_out = i > 0 && mine[i] == its[i];
        if (is_left_out && shown_mine.back() == "…") continue;
        shown_mine.push_back(is_left_out ? "…" : mine[i]);
        shown_its.push_back(is_left_out ? "…" : its[i]);
    }
    return {with_parts(one, shown_mine), with_parts(other, shown_its)};
}

}
