#pragma once

#include <string>
#include <vector>

namespace umbral::grader {

/// Rows of one kind in a table of several, such as the events "zoom": what they are called, and what each of their
/// numbers is, that of the kind too. No columns where these have no names.
struct NamedRows {
    std::string name;
    std::vector<std::string> columns{};
};

}
