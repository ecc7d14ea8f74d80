#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "build/inspection.hpp"

namespace umbral::grader {

/// "glm::lookAt" of "glm::mat<4, 4, float, (glm::qualifier)0> glm::lookAt<float>(glm::vec<3, float> const&)": without
/// what a function returns, takes, and is instantiated with.
[[nodiscard]] std::string qualified_name(std::string_view signature);

/// The first function used that `forbid` does not allow, as a sentence for the student: functions that left code, also
/// inlined ones, by qualified name or by the header that declares them, and symbols wanted from outside. Entries are
/// patterns
/// ("glm::rotate*", "glRotate*") or families ("@transforms").
[[nodiscard]] std::optional<std::string> find_forbidden(const Inspection& inspection,
                                                        const std::vector<std::string>& forbid);

}
