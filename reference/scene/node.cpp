#include "scene/node.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace umbral::scene {
namespace {

using nlohmann::json;

/// The format itself needs seven.
constexpr int maximum_depth = 16;

// RFC 6901.
std::string escaped(const std::string& key)
{
    std::string text;
    for (const char letter : key) text += letter == '~' ? "~0" : letter == '/' ? "~1" : std::string(1, letter);
    return text;
}

/// On one line, printable, and short enough to read.
std::string shown(const json& value)
{
    // A large array is not written out to be cut afterwards.
    if (value.is_array() && value.size() > 16) return fmt::format("a list of {} items", value.size());
    if (value.is_object()) return fmt::format("an object with {} fields", value.size());
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > 80) text = text.substr(0, 77) + "...";
    return text;
}

}

void Node::refuse(const std::string& expected) const
{
    throw std::runtime_error(
        fmt::format("{}: {}expected {}, got {}", file_, pointer_.empty() ? "" : pointer_ + ": ", expected, value_ == nullptr ? "nothing" : shown(*value_)));
}

const json& Node::object() const
{
    if (value_ == nullptr || !value_->is_object()) refuse("an object {…}");
    return *value_;
}

Node Node::member(const std::string& name) const
{
    const auto found = object().find(name);
    return {found == value_->end() ? nullptr : &*found, file_, pointer_ + "/" + escaped(name)};
}

std::vector<std::pair<std::string, Node>> Node::members(std::size_t most) const
{
    if (object().size() > most) refuse(fmt::format("at most {} fields", most));
    std::vector<std::pair<std::string, Node>> result;
    for (const auto& [name, value] : value_->items()) result.emplace_back(name, Node(&value, file_, pointer_ + "/" + escaped(name)));
    return result;
}

void Node::allow_only(std::initializer_list<std::string_view> known) const
{
    for (const auto& [name, value] : object().items())
        if (std::find(known.begin(), known.end(), name) == known.end()) member(name).refuse(fmt::format("one of the fields {}", fmt::join(known, ", ")));
}

std::vector<Node> Node::items(std::size_t least, std::size_t most) const
{
    if (value_ == nullptr || !value_->is_array() || value_->size() < least || value_->size() > most)
        refuse(fmt::format("a list of {} to {} items", least, most));
    std::vector<Node> result;
    result.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i) result.push_back({&(*value_)[i], file_, fmt::format("{}/{}", pointer_, i)});
    return result;
}

std::string Node::text(std::size_t most) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    const auto is_control = [](char byte) { return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F; };
    if (text == nullptr || text->empty() || text->size() > most || std::any_of(text->begin(), text->end(), is_control))
        refuse(fmt::format("a text of 1 to {} bytes on one line", most));
    return *text;
}

std::size_t Node::one_of(const std::vector<std::string>& choices) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    const auto found = text == nullptr ? choices.end() : std::find(choices.begin(), choices.end(), *text);
    if (found == choices.end() && choices.size() > 12) refuse(fmt::format("one of {} names such as \"{}\"", choices.size(), choices.front()));
    if (found == choices.end()) refuse(choices.empty() ? "no name: none is defined" : fmt::format("one of \"{}\"", fmt::join(choices, "\", \"")));
    return static_cast<std::size_t>(found - choices.begin());
}

float Node::number(double low, double high) const
{
    const double value = value_ != nullptr && value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(value >= low && value <= high)) refuse(fmt::format("a number from {} to {}", low, high));
    return static_cast<float>(value);
}

int Node::integer(int low, int high) const
{
    const double value = value_ != nullptr && value_->is_number_integer() ? value_->get<double>() : low - 1.0;
    if (!(value >= low && value <= high)) refuse(fmt::format("a whole number from {} to {}", low, high));
    return static_cast<int>(value);
}

glm::vec2 Node::vector2(double low, double high) const
{
    const std::vector<Node> parts = items(2, 2);
    return {parts[0].number(low, high), parts[1].number(low, high)};
}

glm::vec3 Node::vector3(double low, double high) const
{
    const std::vector<Node> parts = items(3, 3);
    return {parts[0].number(low, high), parts[1].number(low, high), parts[2].number(low, high)};
}

json parse_json_text(std::string_view text, const std::string& file)
{
    std::vector<std::set<std::string>> open_objects;
    const auto watch = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > maximum_depth) throw std::runtime_error(fmt::format("{}: expected lists and objects at most {} deep, got more", file, maximum_depth));
        if (event == json::parse_event_t::object_start) open_objects.emplace_back();
        if (event == json::parse_event_t::object_end) open_objects.pop_back();
        if (event == json::parse_event_t::key && !open_objects.back().insert(parsed.get<std::string>()).second)
            throw std::runtime_error(fmt::format("{}: expected each key once in an object, got {} twice", file, shown(parsed)));
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), watch);
    } catch (const json::exception& error) {
        throw std::runtime_error(fmt::format("{}: expected JSON, got text that is not: {}", file, error.what()));
    }
}

json read_json_file(const std::filesystem::path& file, std::size_t most)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        throw std::runtime_error(fmt::format("{}: expected a file, got nothing: there is none of this name", file.string()));
    std::ifstream stream(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file, error) || !stream)
        throw std::runtime_error(fmt::format("{}: expected a readable regular file, got none", file.string()));
    // By pieces: memory follows what is there, not what might be.
    std::string text;
    for (std::string piece(1U << 16U, '\0'); stream && text.size() <= most;) {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > most) throw std::runtime_error(fmt::format("{}: expected at most {} bytes, got more", file.string(), most));
    return parse_json_text(text, file.string());
}

}
