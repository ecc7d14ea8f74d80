#pragma once

#include <nlohmann/json_fwd.hpp>
#include <umbral/record/questions.hpp>

namespace umbral::grader {

/// What a run is to tell of its questions, as its job says it.
[[nodiscard]] nlohmann::json to_json(const Inquiry& inquiry);
/// The same read back; trusts what the grader wrote.
[[nodiscard]] Inquiry inquiry_from_json(const nlohmann::json& json);

/// Are questions taken down? In a student's run they never are.
[[nodiscard]] bool asks_anything(const Inquiry& inquiry);

}
