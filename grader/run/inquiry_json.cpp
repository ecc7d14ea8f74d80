#include "run/inquiry_json.hpp"

#include <nlohmann/json.hpp>

namespace umbral::grader {

nlohmann::json to_json(const Inquiry& inquiry)
{
    nlohmann::json json = {{"questions", inquiry.questions},
                           {"blocks", inquiry.blocks},
                           {"wanted", inquiry.wanted},
                           {"in_full", inquiry.in_full},
                           {"grain", {inquiry.grain.bits, inquiry.grain.smaller}}};
    json["others"] = nlohmann::json::array();
    for (const OtherQuestion& other : inquiry.others) {
        nlohmann::json also = nlohmann::json::array();
        for (const OtherPlace& one : other.also) also.push_back({one.function, one.place});
        json["others"].push_back({other.function, other.place, other.change, other.other, std::move(also)});
    }
    return json;
}

Inquiry inquiry_from_json(const nlohmann::json& json)
{
    Inquiry inquiry{.questions = json.at("questions"),
                    .blocks = json.at("blocks"),
                    .wanted = json.at("wanted"),
                    .in_full = json.at("in_full"),
                    .grain = {json.at("grain").at(0), json.at("grain").at(1)}};
    for (const nlohmann::json& other : json.at("others")) {
        inquiry.others.push_back({other.at(0), other.at(1), other.at(2), other.at(3)});
        for (const nlohmann::json& one : other.at(4)) inquiry.others.back().also.push_back({one.at(0), one.at(1)});
    }
    return inquiry;
}

bool asks_anything(const Inquiry& inquiry) { return inquiry.questions || inquiry.blocks || !inquiry.wanted.empty(); }

}
