#pragma once

#include <nlohmann/json.hpp>

namespace umbral::grader {

/// docs/schemas/exercise.schema.json with what follows from the judges' records written anew: which judges there are,
/// which fields each takes, and what it demands of a check. Everything else, the order of keys too, stays as it is;
/// what was made before gives way. Throws std::runtime_error if `schema` describes no check, with what was expected
/// where.
[[nodiscard]] nlohmann::ordered_json with_judges(nlohmann::ordered_json schema);

}
