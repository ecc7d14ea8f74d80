#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <umbral/core/random.hpp>
#include <umbral/record/variation.hpp>

namespace umbral {

/// What a driver is given to run one case: its name, random numbers from this case's seed, the text of files that are
/// not C++, and how inputs that are written down are to differ from what is written.
struct Case {
    std::string name;
    Random random;
    std::map<std::string, std::string, std::less<>> sources;
    Variation vary{};

    /// The text of a submitted file (a shader, say). Throws std::out_of_range if the unit has no such file.
    [[nodiscard]] const std::string& source(std::string_view file) const
    {
        const auto found = sources.find(file);
        if (found == sources.end())
            throw std::out_of_range("case '" + name + "': no source file named '" + std::string(file) + "'");
        return found->second;
    }
};

}
