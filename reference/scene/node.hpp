#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbral::scene {

/// One value of a JSON file and the place where it stands (a JSON pointer), so that every complaint names it. Refers to the JSON it was made from.
///
/// All readers throw std::runtime_error "file: /camera/near: expected …, got …" if the value is missing or of another kind.
class Node {
public:
    Node(const nlohmann::json& root, std::string file) : value_(&root), file_(std::move(file)) {}

    [[nodiscard]] bool given() const noexcept { return value_ != nullptr; }

    /// The member of an object; one that is not there can be asked whether it is given.
    [[nodiscard]] Node member(const std::string& name) const;
    /// All members of an object of at most `most`, sorted by name.
    [[nodiscard]] std::vector<std::pair<std::string, Node>> members(std::size_t most) const;
    /// Refuses members with other names than these.
    void allow_only(std::initializer_list<std::string_view> known) const;
    /// The items of an array of `least` to `most`.
    [[nodiscard]] std::vector<Node> items(std::size_t least, std::size_t most) const;

    /// 1 to `most` bytes without control characters.
    [[nodiscard]] std::string text(std::size_t most) const;
    /// The place of the text in `choices`.
    [[nodiscard]] std::size_t one_of(const std::vector<std::string>& choices) const;
    [[nodiscard]] float number(double low, double high) const;
    [[nodiscard]] int integer(int low, int high) const;
    /// An array of two or three numbers.
    [[nodiscard]] glm::vec2 vector2(double low, double high) const;
    [[nodiscard]] glm::vec3 vector3(double low, double high) const;

    [[noreturn]] void refuse(const std::string& expected) const;

private:
    Node(const nlohmann::json* value, std::string file, std::string pointer) : value_(value), file_(std::move(file)), pointer_(std::move(pointer)) {}
    [[nodiscard]] const nlohmann::json& object() const;

    const nlohmann::json* value_;
    std::string file_;
    std::string pointer_;
};

/// The JSON in a file of at most `most` bytes; refuses what is not a regular file, text that is not JSON, and a key twice in an object.
/// Throws std::runtime_error "file: expected …, got …".
[[nodiscard]] nlohmann::json read_json_file(const std::filesystem::path& file, std::size_t most);
[[nodiscard]] nlohmann::json parse_json_text(std::string_view text, const std::string& file);

}
