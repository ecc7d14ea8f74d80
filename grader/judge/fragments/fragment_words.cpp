#include <fmt/format.h>

#include "judge/fragments/fragments.hpp"

namespace umbral::grader {

FragmentWords::FragmentWords(std::string_view text)
{
    text = text.substr(0, text.find('\n'));
    if (text.empty()) return;
    const std::size_t colon = text.find(": ");
    primitive_ = text.substr(0, colon);
    if (colon == std::string_view::npos) return;
    counted_ = column_groups(text.substr(colon + 2), 2);
    if (!counted_.empty()) row_ = counted_.back().name;
}

std::string FragmentWords::where(const Place& place) const
{
    if (are_pixels()) return fmt::format("pixel ({}, {}) of {} {}", place.x, place.y, primitive_, place.primitive);
    std::string text;
    for (const ColumnGroup& one : counted_)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", one.name, one.first == 0 ? place.x : place.y);
    return fmt::format("{} of {} {}", text, primitive_, place.primitive);
}

}
