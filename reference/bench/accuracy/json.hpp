#pragma once

#include <nlohmann/json_fwd.hpp>

#include "measurement.hpp"

namespace umbral::bench {

/// The measurements as docs/schemas/accuracy.schema.json describes them. Numbers that are not finite become null.
[[nodiscard]] nlohmann::json to_json(const Accuracy& accuracy);

}
