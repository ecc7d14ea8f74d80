#include "umbral/record/changes.hpp"

#include <algorithm>

namespace umbral {
namespace {

const Change* change_of(const Part& part, std::string_view name)
{
    for (const std::span<const Change> known : {part.changes, part.moves})
        if (const auto found = std::ranges::find(known, name, &Change::name); found != known.end()) return &*found;
    return nullptr;
}

/// Is it the field that an OtherQuestion without a function names so?
bool is_field(const Part& part, std::string_view name)
{
    if (part.owner.empty() || part.place.depth == 0 || !name.starts_with(part.owner)) return false;
    name.remove_prefix(part.owner.size());
    return name.starts_with('.') && name.substr(1) == part.place.names[part.place.depth - 1];
}

bool stand_in_one_struct(const Part& one, const Part& other)
{
    return one.within != nullptr && one.within == other.within && one.owner == other.owner && !one.owner.empty();
}

/// Those that may be taken for parts[one], the nearest first; of a list's element, its own fields.
std::vector<std::size_t> alike(std::span<const Part> parts, std::size_t one)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // Deeper fields than places tell have the same.
        const bool fits = parts[one].of_element ? stand_in_one_struct(parts[one], parts[i]) : !parts[i].of_element;
        if (fits && parts[i].type == parts[one].type && parts[i].place != parts[one].place) found.push_back(i);
    }
    std::ranges::stable_sort(found, {}, [&](std::size_t i) { return i < one ? one - i : i - one; });
    found.resize(std::min(found.size(), most_taken_for_one));
    return found;
}

void change_part(const Part& part, std::string_view change, const Part* other)
{
    if (other != nullptr && other->type != part.type) return;
    if (other != nullptr && change.empty()) part.exchange(part.value, other->value);
    if (other != nullptr && change == taken_for_another) part.take(part.value, other->value);
    if (other != nullptr) return;
    if (const Change* const known = change_of(part, change)) known->make(part.value);
}

}

std::string field_of(const Part& part)
{
    if (part.owner.empty() || part.place.depth == 0) return "";
    return std::string(part.owner) + "." + std::string(part.place.names[part.place.depth - 1]);
}

std::vector<OtherQuestion> other_questions(std::string_view function, std::span<const Part> parts)
{
    std::vector<OtherQuestion> all;
    const std::string name(function);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const std::string place = part.place.text();
        const std::string field = field_of(part);
        for (const Change& change : part.changes) {
            if (!part.of_element) all.push_back({name, place, std::string(change.name), ""});
            if (!field.empty()) all.push_back({"", field, std::string(change.name), ""});
        }
        for (const std::size_t j : alike(parts, i)) {
            if (!part.of_element) all.push_back({name, place, std::string(taken_for_another), parts[j].place.text()});
            if (stand_in_one_struct(part, parts[j]))
                all.push_back({"", field, std::string(taken_for_another), field_of(parts[j])});
        }
        for (std::size_t j = i + 1; j < parts.size() && !part.of_element; ++j)
            if (part.type == parts[j].type && !parts[j].of_element)
                all.push_back({name, place, "", parts[j].place.text()});
    }
    return all;
}

std::vector<OtherQuestion> moved_questions(std::string_view function, std::span<const Part> parts)
{
    std::vector<OtherQuestion> all;
    for (const Part& part : parts)
        for (const Change& move : part.moves)
            if (!part.of_element) all.push_back({std::string(function), part.place.text(), std::string(move.name), ""});
    return all;
}

AskedInstead::AskedInstead(const OtherQuestion& question) : change_(question.change)
{
    changed_.push_back({question.function, {question.place}, {question.other}});
    for (const OtherPlace& place : question.also) changed_.push_back({place.function, {place.place}, {""}});
}

bool AskedInstead::means(std::string_view function) const
{
    return std::ranges::any_of(changed_, [&](const Changed& one) {
        return one.function.empty() || (one.function == function && one.is_looked_for);
    });
}

bool AskedInstead::leaves_out(std::string_view function) const
{
    return change_ == left_out && std::ranges::find(changed_, function, &Changed::function) != changed_.end();
}

const Part* AskedInstead::Known::among(std::span<const Part> parts)
{
    if (place && index < parts.size() && !parts[index].of_element && parts[index].place == *place) return &parts[index];
    for (index = 0; index < parts.size(); ++index) {
        const Part& part = parts[index];
        if (part.of_element || (place ? part.place != *place : part.place.text() != text)) continue;
        place = part.place;
        return &part;
    }
    return nullptr;
}

void AskedInstead::change_fields(std::span<const Part> parts) const
{
    const std::string& other = changed_.front().other.text;
    for (const Part& part : parts) {
        if (!is_field(part, changed_.front().part.text)) continue;
        if (other.empty()) change_part(part, change_, nullptr);
        for (const Part& one : parts)
            if (!other.empty() && stand_in_one_struct(part, one) && is_field(one, other))
                change_part(part, change_, &one);
    }
}

void AskedInstead::change(std::string_view function, std::span<const Part> parts)
{
    if (changed_.front().function.empty()) return change_fields(parts);
    for (Changed& one : changed_) {
        if (one.function != function || !one.is_looked_for) continue;
        const Part* const part = one.part.among(parts);
        const Part* const other = one.other.text.empty() ? nullptr : one.other.among(parts);
        one.is_looked_for = part != nullptr && (other != nullptr || one.other.text.empty());
        if (one.is_looked_for) change_part(*part, change_, other);
    }
}

}
