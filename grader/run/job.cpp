#include "run/job.hpp"

#include <nlohmann/json.hpp>

#include "run/inquiry_json.hpp"

namespace umbral::grader {

Job job_from(const std::string& text)
{
    const nlohmann::json json = nlohmann::json::parse(text);
    return {json.at("case"),
            json.at("stream"),
            json.at("driver"),
            json.at("solution"),
            json.at("used"),
            json.at("memory"),
            json.at("cpu_seconds"),
            {json.at("counted_table"), json.at("counted_sizes")},
            inquiry_from_json(json.at("inquiry")),
            {json.at("passed_over"), json.at("passed_over_functions"), json.at("end"), json.at("asked_only")},
            json.at("beside").is_null() ? std::nullopt : std::optional<std::uint64_t>(json.at("beside")),
            json.at("mutant"),
            static_cast<FreshMemory>(json.at("fresh_memory").get<int>())};
}

}
