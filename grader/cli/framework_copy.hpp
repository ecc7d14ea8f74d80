#pragma once

#include <filesystem>
#include <span>

#include "build/toolchain.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// Puts what an editor needs to understand the units' stubs into a workspace: the framework's headers that they
/// include, with all that those include, below `include/`, and the compiler's flags as `compile_flags.txt`. Headers are
/// written anew; flags that are there stay, since a student may have added some. Nothing of it is read when the
/// workspace is handed in. Throws std::filesystem::filesystem_error.
void copy_framework(const Toolchain& tools, std::span<const Exercise> exercises,
                    const std::filesystem::path& workspace);

}
