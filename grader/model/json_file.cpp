#include "model/json_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

namespace umbral::grader {

nlohmann::json parse_json(std::string_view text, const std::string& where)
{
    using json = nlohmann::json;
    std::vector<std::set<std::string>> open_objects;
    const auto refuse_twice = [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) open_objects.emplace_back();
        if (event == json::parse_event_t::object_end) open_objects.pop_back();
        if (event == json::parse_event_t::key && !open_objects.back().insert(parsed.get<std::string>()).second)
            throw std::runtime_error(fmt::format("{}: expected each key once in an object, got \"{}\" twice", where, parsed.get<std::string>()));
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), refuse_twice);
    } catch (const json::exception& error) {
        throw std::runtime_error(fmt::format("{}: expected JSON, got text that is not: {}", where, error.what()));
    }
}

nlohmann::json read_json(const std::filesystem::path& file, std::size_t limit)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !std::filesystem::is_regular_file(file)) throw std::runtime_error(fmt::format("{}: expected a readable regular file", file.string()));
    std::string text(limit + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > limit) throw std::runtime_error(fmt::format("{}: expected at most {} bytes, got more", file.string(), limit));
    return parse_json(text, file.string());
}

}
