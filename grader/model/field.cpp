#include "model/field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "model/recording.hpp"

namespace umbral::grader {
namespace {

std::size_t count_characters(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

}

void Field::refuse(const std::string& expected) const
{
    const std::string got = value_ == nullptr ? "nothing" : printable(value_->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), 80);
    throw std::runtime_error(fmt::format("{}: {}expected {}, got {}", file_, path_.empty() ? "" : path_ + ": ", expected, got));
}

const nlohmann::json& Field::object() const
{
    if (value_ == nullptr || !value_->is_object()) refuse("an object {…}");
    return *value_;
}

Field Field::member(const std::string& name) const
{
    const auto found = object().find(name);
    return {found == value_->end() ? nullptr : &*found, file_, path_.empty() ? name : path_ + "." + name};
}

std::vector<std::string> Field::names() const
{
    std::vector<std::string> result;
    for (const auto& member : object().items()) result.push_back(member.key());
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
    for (std::size_t i = 0; i < value_->size(); ++i) result.push_back({&(*value_)[i], file_, fmt::format("{}[{}]", path_, i)});
    return result;
}

std::string Field::text(std::size_t most) const
{
    const std::string* text = value_ == nullptr ? nullptr : value_->get_ptr<const std::string*>();
    const bool fits = text != nullptr && !text->empty() && count_characters(*text) <= most;
    if (!fits || text->find_first_of("\n\t") != std::string::npos || text->front() == ' ' || text->back() == ' ' || printable(*text, 4 * most) != *text)
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
