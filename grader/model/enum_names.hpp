#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace umbral::grader {

/// What a value is called in JSON, and in words for people. One without a name in JSON is not written there.
template <class Value>
struct EnumNames {
    Value value;
    std::string_view in_json;
    std::string_view in_words;
};

/// The names of a value. Throws std::invalid_argument for a number that is none of the declared ones; `what` begins the
/// message.
template <class Value, std::size_t Size>
[[nodiscard]] const EnumNames<Value>& names_of(const std::array<EnumNames<Value>, Size>& names, Value value,
                                               std::string_view what)
{
    const auto found = std::ranges::find(names, value, &EnumNames<Value>::value);
    if (found != names.end()) return *found;
    throw std::invalid_argument(std::string(what) + ": expected one of the " + std::to_string(Size) +
                                " declared ones, got number " + std::to_string(static_cast<int>(value)));
}

/// The value of that JSON name. Throws std::invalid_argument for any other text; `what` begins the message.
template <class Value, std::size_t Size>
[[nodiscard]] Value value_named(const std::array<EnumNames<Value>, Size>& names, std::string_view name,
                                std::string_view what)
{
    std::string known;
    for (const EnumNames<Value>& candidate : names) {
        if (candidate.in_json.empty()) continue;
        if (candidate.in_json == name) return candidate.value;
        known += (known.empty() ? "" : ", ") + std::string(candidate.in_json);
    }
    throw std::invalid_argument(std::string(what) + ": expected one of " + known + ", got '" + std::string(name) + "'");
}

}
