#pragma once

#include <string>
#include <vector>

namespace umbral::gl {

/// What a shared library shows to others.
struct Exports {
    std::vector<std::string> functions;
    std::vector<std::string> writable_data;  ///< objects in memory that stays writable once loaded
    std::vector<std::string> unique;         ///< STB_GNU_UNIQUE symbols
    std::vector<std::string> needed;         ///< libraries it is linked with
};

/// Reads the dynamic symbols of a 64-bit ELF library. Throws std::runtime_error if it is none.
[[nodiscard]] Exports read_exports(const std::string& path);

}
