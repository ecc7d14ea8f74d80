#include "text/json_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "text/printable.hpp"

namespace umbral {

nlohmann::json parse_json(std::string_view text, const std::string& where)
{
    using json = nlohmann::json;
    constexpr int deepest = 16;
    std::vector<std::set<std::string>> open_objects;
    const auto watch = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > deepest)
            throw std::runtime_error(
                fmt::format("{}: expected lists and objects at most {} deep, got more", where, deepest));
        if (event == json::parse_event_t::object_start) open_objects.emplace_back();
        if (event == json::parse_event_t::object_end) open_objects.pop_back();
        if (event != json::parse_event_t::key) return true;
        const auto& key = parsed.get_ref<const std::string&>();
        if (!open_objects.back().insert(key).second)
            throw std::runtime_error(
                fmt::format("{}: expected each key once in an object, got \"{}\" twice", where, printable(key, 200)));
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), watch);
    } catch (const json::exception& error) {
        throw std::runtime_error(fmt::format("{}: expected JSON, got text that is not: {}", where, error.what()));
    }
}

nlohmann::json read_json(const std::filesystem::path& file, std::size_t limit)
{
    const auto refuse = [&](const std::string& got) {
        throw std::runtime_error(fmt::format("{}: expected a readable regular file, got {}", file.string(), got));
    };
    std::error_code error;
    if (!std::filesystem::exists(file, error)) refuse("nothing: there is none of this name");
    if (!std::filesystem::is_regular_file(file, error)) refuse("something else");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse("one that cannot be read");
    // By pieces: memory follows what is there, not what might be.
    std::string text;
    for (std::string piece(1U << 16U, '\0'); stream && text.size() <= limit;) {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > limit)
        throw std::runtime_error(fmt::format("{}: expected at most {} bytes, got more", file.string(), limit));
    return parse_json(text, file.string());
}

}
