#include "report/json_text.hpp"

#include <nlohmann/json.hpp>

namespace umbral::grader {
namespace {

std::string text_of(const nlohmann::json& json)
{
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}

std::string report_json(const SubmissionResult& result, const Fingerprint& fingerprint)
{
    return text_of(to_json(result, fingerprint));
}

std::string class_json(const ClassResult& result) { return text_of(to_json(result)); }

}
