#pragma once

#include <span>
#include <string>

#include "validate/validate.hpp"

namespace umbral::grader {

/// The findings about mistakes as a page of Markdown, a table a unit: what is wrong, the credit it got (lowest to
/// highest over the seeds), its share of the hard cases, and what a student with this mistake is told. Units and
/// mistakes in the order of the findings.
[[nodiscard]] std::string validation_table(std::span<const Finding> findings, std::span<const Exercise> exercises);

}
