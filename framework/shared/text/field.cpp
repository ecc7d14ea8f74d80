#include "text/field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "text/printable.hpp"
#include "text/utf8.hpp"

namespace umbral {
namespace {

std::size_t count_characters(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return !is_continuation(byte); }));
}

/// On one line, printable, and short enough to read.
std::string shown(const nlohmann::json& value)
{
    constexpr std::size_t longest = 80;
    // What is large is not written out to be cut afterwards.
    const bool large = value.is_structured() && value.size() > longest / 4;
    const std::string text = large ? "" : value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (value.is_array() && (large || text.size() > longest)) return fmt::format("a list of {} items", value.size());
    if (value.is_object() && (large || text.size() > longest))
        return fmt::format("an object with {} fields", value.size());
    if (text.size() <= longest) return printable(text, 3 * longest);
    std::size_t end = longest - 3;
    while (is_continuation(text[end])) --end;
    return printable(std::string_view(text).substr(0, end), 3 * longest) + "...";
}

bool is_plain(char letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '-' || letter == '_';
}

}

void Field::refuse(const std::string& expected) const
{
    const std::string got = value_ == nullptr ? "nothing" : shown(*value_);
    throw std::runtime_error(
        fmt::format("{}: {}expected {}, got {}", file_, path_.empty() ? "" : path_ + ": ", expected, got));
}

std::string Field::path_of(const std::string& name) const
{
    if (name.empty() || !std::all_of(name.begin(), name.end(), is_plain))
        return fmt::format("{}[{}]", path_, shown(name));
    return path_.empty() ? name : path_ + "." + name;
}

const nlohmann::json& Field::object() const
{
    if (value_ == nullptr || !value_->is_object()) refuse("an object {…}");
    return *value_;
}

Field Field::member(const std::string& name) const
{
    const auto found = object().find(name);
    return {found == value_->end() ? nullptr : &*found, file_, path_of(name)};
}

std::vector<std::string> Field::names() const
{
    std::vector<std::string> result;
    for (const auto& member : object().items()) result.push_back(member.key());
    return result;
}

std::vector<std::pair<std::string, Field>> Field::members(std::size_t most) const
{
    if (object().size() > most) refuse(fmt::format("at most {} fields", most));
    std::vector<std::pair<std::string, Field>> result;
    for (const auto& [name, value] : value_->items()) result.emplace_back(name, Field(&value, file_, path_of(name)));
    return result;
}

void Field::allow_only(std::span<const std::string_view> known) const
{
    for (const std::string& name : names())
        if (std::find(known.begin(), known.end(), name) == known.end())
            member(name).refuse(fmt::format("no field of this name (known are: {})", fmt::join(known, ", ")));
}

std::vector<Field> Field::items(std::size_t least, std::size_t most) const
{
    if (value_ == nullptr || !value_->is_array() || value_->size() < least || value_->size() > most)
        refuse(fmt::format("a list of {} to {} items", least, most));
    std::vector<Field> result;
    result.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i)
        result.push_back({&(*value_)[i], file_, fmt::format("{}[{}]", path_, i)});
    return result;
}

std::string Field::text(std::size_t most) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    const bool fits = text != nullptr && !text->empty() && count_characters(*text) <= most;
    if (!fits || text->find_first_of("\n\t") != std::string::npos || text->front() == ' ' || text->back() == ' ' ||
        printable(*text, 4 * most) != *text)
        refuse(fmt::format("one line of text, 1 to {} characters, no space at its ends", most));
    return *text;
}

std::vector<std::string> Field::texts(std::size_t least, std::size_t most, std::size_t most_characters) const
{
    std::vector<std::string> result;
    std::set<std::string> seen;
    for (const Field& item : items(least, most)) {
        result.push_back(item.text(most_characters));
        if (!seen.insert(result.back()).second) item.refuse("an item not in the list before");
    }
    return result;
}

std::string Field::any_text(std::size_t most) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    if (text == nullptr || text->size() > most) refuse(fmt::format("a text of at most {} bytes", most));
    return *text;
}

std::size_t Field::one_of(std::span<const std::string> choices) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    const auto found = text == nullptr ? choices.end() : std::find(choices.begin(), choices.end(), *text);
    if (found == choices.end() && choices.size() > 12)
        refuse(fmt::format("one of {} names such as \"{}\"", choices.size(), choices.front()));
    if (found == choices.end())
        refuse(choices.empty() ? "no name: none is defined"
                               : fmt::format("one of \"{}\"", fmt::join(choices, "\", \"")));
    return static_cast<std::size_t>(found - choices.begin());
}

bool Field::is_null() const noexcept { return value_ != nullptr && value_->is_null(); }

bool Field::boolean() const
{
    if (value_ == nullptr || !value_->is_boolean()) refuse("true or false");
    return value_->get<bool>();
}

double Field::number(double low, double high) const
{
    if (value_ == nullptr || !value_->is_number()) refuse(fmt::format("a number from {} to {}", low, high));
    const double value = value_->get<double>();
    if (!(value >= low && value <= high)) refuse(fmt::format("a number from {} to {}", low, high));
    return value;
}

int Field::integer(int low, int high) const
{
    const double value = value_ != nullptr && value_->is_number_integer() ? value_->get<double>() : low - 1.0;
    if (!(value >= low && value <= high)) refuse(fmt::format("a whole number from {} to {}", low, high));
    return static_cast<int>(value);
}

}
