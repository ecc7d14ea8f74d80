#include "support/schema.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace umbral::test {

nlohmann::json read_schema(const std::string& name)
{
    const std::string path = std::string(UMBRAL_SOURCE_DIR) + "/docs/schemas/" + name + ".schema.json";
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return nlohmann::json::parse(file);
}

Schema::Schema(const std::string& name) : schema_(std::make_unique<valijson::Schema>())
{
    const nlohmann::json text = read_schema(name);
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(text), *schema_);
}

Schema::~Schema() = default;

std::string Schema::complaints(const nlohmann::json& document) const
{
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(*schema_, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};
    std::string text;
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
        for (const std::string& step : error.context) text += step;
        text += ": " + error.description + "\n";
    }
    return text.empty() ? "invalid for no reason given" : text;
}

}
