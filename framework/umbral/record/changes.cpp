#include "umbral/record/changes.hpp"

#include <algorithm>

namespace umbral {

std::string field_of(const Part& part)
{
    if (part.owner.empty() || part.place.depth == 0) return "";
    return std::string(part.owner) + "." + std::string(part.place.names[part.place.depth - 1]);
}

std::vector<OtherQuestion> other_questions(std::string_view function, std::span<const Part> parts)
{
    std::vector<OtherQuestion> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const Change& change : parts[i].changes) {
            if (!parts[i].of_element)
                all.push_back({std::string(function), parts[i].place.text(), std::string(change.name), ""});
            if (const std::string field = field_of(parts[i]); !field.empty())
                all.push_back({"", field, std::string(change.name), ""});
        }
        for (std::size_t j = i + 1; j < parts.size() && !parts[i].of_element; ++j)
            if (parts[i].type == parts[j].type && !parts[j].of_element)
                all.push_back({std::string(function), parts[i].place.text(), "", parts[j].place.text()});
    }
    return all;
}

void change_parts(const OtherQuestion& question, std::span<const Part> parts, ChangedParts& which)
{
    if (question.function.empty()) {
        for (const Part& part : parts)
            if (field_of(part) == question.place)
                for (const Change& change : part.changes)
                    if (change.name == question.change) change.make(part.value);
        return;
    }
    if (!which.known) {
        const auto at = [&](const std::string& place) {
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (!parts[i].of_element && parts[i].place.text() == place) return std::optional(i);
            return std::optional<std::size_t>();
        };
        which = {true, at(question.place), question.other.empty() ? std::nullopt : at(question.other), nullptr};
        if (which.part)
            for (const Change& change : parts[*which.part].changes)
                if (change.name == question.change) which.make = change.make;
    }
    if (!which.part) return;
    const Part& part = parts[*which.part];
    if (which.other && parts[*which.other].type == part.type)
        part.exchange(part.value, parts[*which.other].value);
    else if (which.make != nullptr)
        which.make(part.value);
}

}
