#include "manifest/exercise_schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "judge/judges.hpp"
#include "manifest/check_fields.hpp"

namespace umbral::grader {
namespace {

using Json = nlohmann::ordered_json;

/// JSON schema of checks whose judge is one of those for which `chosen` holds.
template <class Chosen>
Json judged_by(const Chosen& chosen)
{
    Json names = Json::array();
    for (const JudgeRecord* record : judges())
        if (chosen(*record)) names.push_back(record->name);
    return {{"required", {"judge"}}, {"properties", {{"judge", {{"enum", names}}}}}};
}

Json without(const std::string& field) { return {{"properties", {{field, false}}}}; }

Json without_in_relation(const std::string& field) { return {{"properties", {{"relation", without(field)}}}}; }

/// What one judge demands of its own checks, and what it alone takes.
void add_own_rules(const JudgeRecord& record, Json& rules)
{
    const Json own = judged_by([&](const JudgeRecord& one) { return &one == &record; });
    for (const OwnField& field : record.own_fields) {
        Json rule{{"if", own}};
        if (!field.optional) rule["then"] = {{"required", {field.name}}};
        rule["else"] = without(std::string(field.name));
        rules.push_back(std::move(rule));
    }
    if (!record.schema_of_check.empty()) rules.push_back({{"if", own}, {"then", Json::parse(record.schema_of_check)}});
}

/// What depends on the judge, each rule as an if and a then.
Json rules_of_judges()
{
    Json rules = Json::array();
    rules.push_back({{"if", judged_by([](const JudgeRecord& one) { return one.needs_tolerance; })},
                     {"then", {{"required", {"tolerance"}}}}});
    rules.push_back({{"if", judged_by([](const JudgeRecord& one) { return !one.pairs; })},
                     {"then", {{"properties", {{"pairs", {{"const", false}}}}}}}});
    rules.push_back(
        {{"if", judged_by([](const JudgeRecord& one) { return !has_range(one); })}, {"then", without("range")}});
    rules.push_back({{"if", judged_by([](const JudgeRecord& one) { return !one.relation.possible; })},
                     {"then", without("relation")}});
    rules.push_back({{"if", judged_by([](const JudgeRecord& one) { return !one.relation.moves; })},
                     {"then", without_in_relation("shift")}});
    rules.push_back({{"if", judged_by([](const JudgeRecord& one) { return !one.relation.scales; })},
                     {"then", without_in_relation("scale")}});
    for (const JudgeRecord* record : judges()) add_own_rules(*record, rules);
    return rules;
}

/// Is this rule about the judge, and so one that is made anew?
bool is_of_judges(const Json& rule)
{
    static const Json::json_pointer judge("/if/properties/judge");
    return rule.contains(judge);
}

Json& part(Json& schema, const std::string& where)
{
    const Json::json_pointer pointer(where);
    if (!schema.contains(pointer))
        throw std::runtime_error(fmt::format("exercise.schema.json: expected something at {}, found nothing", where));
    return schema[pointer];
}

}

Json with_judges(Json schema)
{
    std::vector<std::string_view> names;
    std::vector<std::string_view> compared;
    Json& properties = part(schema, "/definitions/check/properties");
    for (auto property = properties.begin(); property != properties.end();)
        property =
            std::ranges::count(check_fields, property.key()) == 0 ? properties.erase(property) : std::next(property);
    for (const JudgeRecord* record : judges()) {
        names.push_back(record->name);
        compared.push_back(record->compares);
        for (const OwnField& field : record->own_fields)
            properties[std::string(field.name)] = Json::parse(field.schema);
    }
    const std::string_view last = compared.back();
    compared.pop_back();
    Json& judge = part(schema, "/definitions/check/properties/judge");
    judge["description"] = fmt::format("What is compared: {}, or {}.", fmt::join(compared, ", "), last);
    judge["enum"] = names;
    Json& rules = part(schema, "/definitions/check/allOf");
    Json all = Json::array();
    for (Json& rule : rules)
        if (!is_of_judges(rule)) all.push_back(std::move(rule));
    for (Json& rule : rules_of_judges()) all.push_back(std::move(rule));
    rules = std::move(all);
    return schema;
}

}
