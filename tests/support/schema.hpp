#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace umbral::test {

/// The text of a schema of docs/schemas: "class". Needs UMBRAL_SOURCE_DIR.
inline nlohmann::json read_schema(const std::string& name)
{
    const std::string path = std::string(UMBRAL_SOURCE_DIR) + "/docs/schemas/" + name + ".schema.json";
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return nlohmann::json::parse(file);
}

/// A schema of docs/schemas, ready to judge.
class Schema {
public:
    explicit Schema(const std::string& name)
    {
        const nlohmann::json text = read_schema(name);
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
    }

    /// What is wrong with `document`; empty if nothing is.
    [[nodiscard]] std::string complaints(const nlohmann::json& document) const
    {
        valijson::Validator validator;
        valijson::ValidationResults results;
        if (validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};
        std::string text;
        valijson::ValidationResults::Error error;
        while (results.popError(error)) {
            for (const std::string& step : error.context) text += step;
            text += ": " + error.description + "\n";
        }
        return text.empty() ? "invalid for no reason given" : text;
    }

private:
    valijson::Schema schema_;
};

}
