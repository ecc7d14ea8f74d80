#pragma once

#include <string>

#include "model/exercise.hpp"
#include "text/field.hpp"

// The parts of the manifest that say which recorded values a check looks at.
namespace umbral::grader {

/// A name under which a driver records: letters, digits and " _.-", not a margin's.
[[nodiscard]] std::string read_recorded_name(const Field& field);

/// The relation of a check whose other fields were read; refuses what its judge cannot do.
[[nodiscard]] Relation read_relation(const Field& field, const Check& check);

}
