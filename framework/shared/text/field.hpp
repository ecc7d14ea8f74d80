#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbral {

/// One value of a JSON file with the place where it stands, so that every complaint can name it. Refers to the JSON it
/// was made from.
///
/// All readers throw std::runtime_error "file: checks[2].points: expected …, got …" if the value is missing or of
/// another kind. Names of other than letters, digits, - and _ stand quoted in the place: nodes["left wing"][0].
class Field {
public:
    Field(const nlohmann::json& root, std::string file) : value_(&root), file_(std::move(file)) {}

    [[nodiscard]] bool given() const noexcept { return value_ != nullptr; }
    /// Is it there, and null?
    [[nodiscard]] bool is_null() const noexcept;

    /// The member of an object; one that is not there can be asked whether it is given.
    [[nodiscard]] Field member(const std::string& name) const;
    /// Names of an object's members, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
    /// All members of an object of at most `most`, sorted by name.
    [[nodiscard]] std::vector<std::pair<std::string, Field>> members(std::size_t most) const;
    /// Refuses members with other names than these.
    void allow_only(std::span<const std::string_view> known) const;
    void allow_only(std::initializer_list<std::string_view> known) const
    {
        allow_only(std::span(known.begin(), known.size()));
    }

    /// The items of an array of `least` to `most`.
    [[nodiscard]] std::vector<Field> items(std::size_t least, std::size_t most) const;
    /// One line of 1 to `most` characters without control characters or space at its ends.
    [[nodiscard]] std::string text(std::size_t most) const;
    /// Items that are such texts, none of them twice.
    [[nodiscard]] std::vector<std::string> texts(std::size_t least, std::size_t most,
                                                 std::size_t most_characters) const;
    /// Any text of at most `most` bytes, as it is: lines, nothing at all.
    [[nodiscard]] std::string any_text(std::size_t most) const;
    /// The place of the text in `choices`.
    [[nodiscard]] std::size_t one_of(std::span<const std::string> choices) const;
    [[nodiscard]] std::size_t one_of(std::initializer_list<std::string> choices) const
    {
        return one_of(std::span(choices.begin(), choices.size()));
    }
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] double number(double low, double high) const;
    [[nodiscard]] int integer(int low, int high) const;

    [[noreturn]] void refuse(const std::string& expected) const;

private:
    Field(const nlohmann::json* value, std::string file, std::string path)
        : value_(value), file_(std::move(file)), path_(std::move(path))
    {
    }
    [[nodiscard]] const nlohmann::json& object() const;
    [[nodiscard]] std::string path_of(const std::string& name) const;

    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

}
