#include "model/unjudged.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace umbral::grader {
namespace {

struct Names {
    Unjudged unjudged;
    std::string_view in_json;
    std::string_view in_words;
};

constexpr std::array names{
    Names{Unjudged::no, "", ""},
    Names{Unjudged::unwritten, "unwritten", "not implemented yet"},
    Names{Unjudged::stopped, "stopped", "no result"},
    Names{Unjudged::not_run, "not_run", "not run"},
};

}

std::string_view to_string(Unjudged unjudged) { return names.at(static_cast<std::size_t>(unjudged)).in_json; }

std::string_view in_words(Unjudged unjudged) { return names.at(static_cast<std::size_t>(unjudged)).in_words; }

Unjudged unjudged_from(std::string_view name)
{
    for (const Names& candidate : names)
        if (!name.empty() && candidate.in_json == name) return candidate.unjudged;
    throw std::invalid_argument("unjudged: expected unwritten, stopped or not_run, got '" + std::string(name) + "'");
}

}
