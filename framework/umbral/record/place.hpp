#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace umbral {

/// A place in a question's arguments: an argument, counted from 0, and names of fields in it, the outer ones first.
/// Deeper fields than `most` have the place of the struct they stand in.
struct Place {
    static constexpr std::size_t most = 5;
    static constexpr std::size_t no_argument = static_cast<std::size_t>(-1);  ///< a program's input has a name only

    std::size_t argument = 0;
    std::size_t depth = 0;
    std::array<std::string_view, most> names{};

    /// The place of a field of what stands here.
    [[nodiscard]] Place operator/(std::string_view field) const
    {
        Place inner = *this;
        if (depth < most) inner.names[inner.depth++] = field;
        return inner;
    }

    /// "0.origin.x", "0[2].x", "light_position.x"
    [[nodiscard]] std::string text() const
    {
        std::string result = argument == no_argument ? "" : std::to_string(argument);
        for (std::size_t i = 0; i < depth; ++i)
            result.append(result.empty() || names[i].starts_with('[') ? "" : ".").append(names[i]);
        return result;
    }

    friend bool operator==(const Place&, const Place&) = default;
};

}
