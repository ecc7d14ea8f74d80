#pragma once

#include "build/inspection.hpp"

namespace umbral::grader {

/// Has a library nowhere to keep something from one call to the next? Not in variables of its own, nor in what the C
/// and C++ libraries remember: their random numbers, streams, locales, handlers and error codes.
[[nodiscard]] bool keeps_nothing(const Inspection& inspection);

}
