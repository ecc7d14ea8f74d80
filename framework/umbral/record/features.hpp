#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <umbral/record/literal.hpp>
#include <vector>

namespace umbral {

/// Numbers that say what a question was about, each with the place in its arguments: "0.origin.x" is the x of the field
/// `origin` of the first argument. Equal types have equal places, whatever their values.
struct Features {
    std::vector<std::string> names;
    std::vector<double> values;

    void add(std::string name, double value)
    {
        names.push_back(std::move(name));
        values.push_back(value);
    }
};

inline constexpr std::string_view component_names[] = {"x", "y", "z", "w"};

namespace detail {

/// Of a list: how long it is, and its least and largest number.
struct Bounds {
    double least = std::numeric_limits<double>::infinity();
    double largest = -std::numeric_limits<double>::infinity();

    void take(const Features& features)
    {
        for (const double value : features.values) {
            least = std::min(least, value);
            largest = std::max(largest, value);
        }
    }
};

}

/// Adds the numbers in `value`, which stands at `place`. Lists give their lengths, their least and their largest
/// number.
template <class Value>
void add_features(const std::string& place, const Value& value, Features& features)
{
    namespace of = literal::detail;
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
        features.add(place, static_cast<double>(value));
    } else if constexpr (of::is_vector<Value>) {
        for (glm::length_t i = 0; i < Value::length(); ++i)
            features.add(place + "." + std::string(component_names[i]), static_cast<double>(value[i]));
    } else if constexpr (of::is_matrix<Value>) {
        for (glm::length_t column = 0; column < Value::length(); ++column)
            for (glm::length_t row = 0; row < Value::col_type::length(); ++row)
                features.add(place + "[" + std::to_string(column) + "][" + std::to_string(row) + "]",
                             static_cast<double>(value[column][row]));
    } else if constexpr (of::is_optional<Value>) {
        features.add(place + ".has_value()", value.has_value() ? 1 : 0);
    } else if constexpr (of::Text<Value>) {
        features.add(place + ".size()", static_cast<double>(std::string_view(value).size()));
    } else if constexpr (of::is_grid<Value>) {
        features.add(place + ".width", value.width);
        features.add(place + ".height", value.height);
    } else if constexpr (of::List<Value>) {
        features.add(place + ".size()", static_cast<double>(value.size()));
        detail::Bounds bounds;
        for (const auto& element : value) {
            Features inside;
            add_features("", element, inside);
            bounds.take(inside);
        }
        features.add("the least number in " + place, value.empty() ? 0 : bounds.least);
        features.add("the largest number in " + place, value.empty() ? 0 : bounds.largest);
    } else if constexpr (reflect::is_plain_struct<Value>) {
        reflect::for_each_field(value, [&](std::string_view name, const auto& field) {
            add_features(place + "." + std::string(name), field, features);
        });
    }
}

}
