#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "build/toolchain.hpp"

namespace umbral::grader {

/// What a built library says about itself. It was made from hostile sources (which may hold assembler), so it is read by
/// umbral-inspect in confinement, never in the grader.
struct Inspection {
    std::vector<std::string> exported;   ///< symbols defined for others, mangled
    std::vector<std::string> undefined;  ///< symbols it wants from others, mangled, without versions
    std::vector<std::string> functions;  ///< demangled names of all functions in the debug information that left code, inlined ones too
};

/// Nothing if the file cannot be read, by its own fault: a compiler's output always can. Throws std::runtime_error if the inspector
/// cannot be run.
[[nodiscard]] std::optional<Inspection> inspect(const Toolchain& tools, const std::filesystem::path& library);

/// The first of `frames` (addresses in the library, return addresses but for the first) that lies in a file of `folder`'s own:
/// "sphere.cpp:17"; empty if there is none.
[[nodiscard]] std::string place_of(const Toolchain& tools, const std::filesystem::path& library, const std::vector<std::uint64_t>& frames);

}
