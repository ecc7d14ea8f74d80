#include "umbral/record/changes.hpp"

#include <algorithm>

namespace umbral {

std::vector<OtherQuestion> other_questions(std::string_view function, std::span<const Part> parts)
{
    std::vector<OtherQuestion> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const Change& change : parts[i].changes)
            all.push_back({std::string(function), parts[i].place, std::string(change.name), ""});
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            if (parts[i].type == parts[j].type)
                all.push_back({std::string(function), parts[i].place, "", parts[j].place});
    }
    return all;
}

void change_parts(const OtherQuestion& question, std::span<const Part> parts)
{
    const auto at = [&](const std::string& place) {
        return std::ranges::find_if(parts, [&](const Part& part) { return part.place == place; });
    };
    const auto part = at(question.place);
    if (part == parts.end()) return;
    if (const auto other = at(question.other); other != parts.end()) {
        if (other->type == part->type) part->exchange(part->value, other->value);
        return;
    }
    const auto change =
        std::ranges::find_if(part->changes, [&](const Change& one) { return one.name == question.change; });
    if (change != part->changes.end()) change->make(part->value);
}

}
