#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "build/inspection.hpp"

namespace umbral::grader {

/// Headers as they lie on the disk, each read once.
class HeaderTexts {
public:
    /// Is the function called in its header what debug information calls it? False where a macro round the include gave
    /// it another name, and where the header cannot be read there.
    [[nodiscard]] bool declares(const InspectedFunction& function);

private:
    const std::vector<std::string>& lines_of(const std::string& file);

    std::map<std::string, std::vector<std::string>> files_;
    std::uintmax_t bytes_ = 0;  ///< of those that were read
};

/// The last name of the qualified one with which `text` begins: "operator" of "mat<4, 4, T, Q>::operator[](int)",
/// "call" of "call(x)"; empty if it begins with none.
[[nodiscard]] std::string declared_name(std::string_view text);

}
