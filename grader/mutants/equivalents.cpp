#include "mutants/equivalents.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace umbral::grader {
namespace {

std::string line_of(const std::string& source, std::size_t number)
{
    std::istringstream stream(source);
    std::string line;
    for (std::size_t i = 0; i < number && std::getline(stream, line); ++i) {
    }
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t") - first + 1);
}

}

std::string entries_file(MutantFamily family) { return family == MutantFamily::slips ? "slips.json" : "mutants.json"; }

std::vector<Equivalent> equivalents_of(const std::filesystem::path& unit, MutantFamily family)
{
    const std::filesystem::path file = unit / entries_file(family);
    if (!std::filesystem::exists(file)) return {};
    std::ifstream stream(file);
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    const std::string expected = file.string() + ": expected a list of {\"line\", \"change\", \"reason\"}, each a text";
    if (!json.is_array()) throw std::runtime_error(expected);
    std::vector<Equivalent> entries;
    for (const auto& one : json) {
        for (const char* field : {"line", "change", "reason"})
            if (!one.is_object() || one.size() != 3 || !one.contains(field) || !one.at(field).is_string() ||
                one.at(field).get<std::string>().empty())
                throw std::runtime_error(expected + ", got " + one.dump());
        entries.push_back({one.at("line"), one.at("change"), one.at("reason")});
    }
    return entries;
}

bool is_about(const Equivalent& entry, const Mutant& mutant, const std::string& source)
{
    return entry.change == mutant.change && entry.line == line_of(source, mutant.line);
}

}
