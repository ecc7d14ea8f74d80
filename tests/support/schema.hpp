#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace valijson {
class Schema;
}

namespace umbral::test {

/// The text of a schema of docs/schemas: "class". Throws std::runtime_error if it cannot be read.
[[nodiscard]] nlohmann::json read_schema(const std::string& name);

/// A schema of docs/schemas, ready to judge.
class Schema {
public:
    explicit Schema(const std::string& name);
    ~Schema();
    Schema(const Schema&) = delete;
    Schema(Schema&&) = delete;
    Schema& operator=(const Schema&) = delete;
    Schema& operator=(Schema&&) = delete;

    /// What is wrong with `document`; empty if nothing is.
    [[nodiscard]] std::string complaints(const nlohmann::json& document) const;

private:
    std::unique_ptr<valijson::Schema> schema_;
};

}
