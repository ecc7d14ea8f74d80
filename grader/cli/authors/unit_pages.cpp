#include "cli/authors/unit_pages.hpp"

#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

#include "cli/paths.hpp"
#include "collect/sources.hpp"

namespace umbral::grader {
namespace {

struct Page {
    std::string beginning;
    std::map<std::string, std::string, std::less<>> rows;
    std::map<std::string, std::string, std::less<>> sections;
};

/// "topic/unit" where a line is about one: behind "| " up to " |", or behind "## "; empty where it is not.
std::string_view unit_in(std::string_view line, std::string_view before, std::string_view behind)
{
    if (!line.starts_with(before)) return "";
    const std::string_view rest = line.substr(before.size());
    const std::string_view name = rest.substr(0, behind.empty() ? rest.size() : rest.find(behind));
    return name.find('/') != std::string_view::npos && name.find(' ') == std::string_view::npos ? name : "";
}

Page parts_of(std::string_view text)
{
    Page page;
    std::string* section = nullptr;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        if (const std::string_view unit = unit_in(line, "## ", ""); !unit.empty())
            section = &page.sections[std::string(unit)];
        const std::string_view row = section == nullptr ? unit_in(line, "| ", " |") : "";
        std::string& part = section != nullptr ? *section : row.empty() ? page.beginning : page.rows[std::string(row)];
        part += line + '\n';
    }
    return page;
}

std::string without_empty_lines_behind(std::string text)
{
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

}

std::string with_other_units(std::string_view fresh, std::string_view kept, std::span<const std::string> order)
{
    Page page = parts_of(fresh);
    Page other = parts_of(kept);
    std::string rows;
    std::string sections;
    for (const std::string& unit : order) {
        // One about which there is nothing to say has a row and no section.
        const bool is_fresh = page.rows.contains(unit) || page.sections.contains(unit);
        Page& from = is_fresh ? page : other;
        rows += from.rows[unit];
        if (const std::string& section = from.sections[unit]; !section.empty())
            sections += '\n' + without_empty_lines_behind(section);
    }
    std::string beginning = without_empty_lines_behind(page.beginning);
    return beginning + rows + sections;
}

void write_unit_page(const Application& application, const std::string& file, const std::string& page)
{
    std::vector<std::string> order;
    for (const Exercise& exercise : application.readable()) order.push_back(exercise.id);
    const std::string kept = std::filesystem::is_regular_file(file) ? read_text(file) : "";
    write_output(file, with_other_units(page, kept, order));
}

}
