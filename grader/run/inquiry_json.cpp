#include "run/inquiry_json.hpp"

#include <nlohmann/json.hpp>

namespace umbral::grader {

nlohmann::json to_json(const Inquiry& inquiry)
{
    nlohmann::json json = {{"questions", inquiry.questions}, {"wanted", inquiry.wanted}, {"in_full", inquiry.in_full}};
    if (inquiry.other)
        json["other"] = {inquiry.other->function, inquiry.other->place, inquiry.other->change, inquiry.other->other};
    return json;
}

Inquiry inquiry_from_json(const nlohmann::json& json)
{
    Inquiry inquiry{.questions = json.at("questions"), .wanted = json.at("wanted"), .in_full = json.at("in_full")};
    if (const auto found = json.find("other"); found != json.end())
        inquiry.other = OtherQuestion{found->at(0), found->at(1), found->at(2), found->at(3)};
    return inquiry;
}

bool asks_anything(const Inquiry& inquiry)
{
    return inquiry.questions || !inquiry.wanted.empty() || inquiry.other;
}

}
