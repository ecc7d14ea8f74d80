#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/paint.hpp"

namespace umbral::grader {

/// Commands that go on from a unit that is not all right. `failing` is the check that is shown, null if none is;
/// `folder` the workspace that they name, if it is not empty.
[[nodiscard]] std::vector<std::string> next_steps(const UnitResult& unit, const CheckResult* failing,
                                                  const std::string& folder, const Paint& paint);

/// " --dir work", behind a command that is to be called for this workspace; nothing where one stands in it.
[[nodiscard]] std::string folder_option(const std::string& folder);

/// "'far away'": an argument that a shell takes as one word.
[[nodiscard]] std::string shell_word(std::string_view text);

}
