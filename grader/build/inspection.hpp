#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "build/toolchain.hpp"

namespace umbral::grader {

/// A symbol of a library's dynamic table.
struct InspectedSymbol {
    std::string name;      ///< as the linker knows it, at most caps::symbol bytes
    std::string readable;  ///< as C++ writes it, at most caps::name bytes
};

/// A function that left code in a library, also one that was inlined.
struct InspectedFunction {
    std::string name;  ///< as C++ writes it, at most caps::name bytes
    std::string file;  ///< where it is declared, without links (RealPaths)
    int line = 0;      ///< the place of its name there, counted from 1; 0 where nothing says it
    int column = 0;
    std::string bare;  ///< its name without scope and template arguments: "rotate", "operator*"
};

/// What a built library says about itself. It was made from hostile sources, so it is read by umbral-inspect in
/// confinement, never in the grader, which demangles nothing: lists and names are bounded where they are made.
struct Inspection {
    std::vector<std::string> missing;          ///< of the interface: names that it does not define, as C++ writes them
    std::vector<InspectedSymbol> undefined;    ///< what it wants from others, without versions
    std::vector<InspectedFunction> functions;  ///< of its debug information
    std::vector<std::string>
        uncounted;  ///< functions, as C++ writes them, and other reasons why its work would not be counted as a whole
    std::uint64_t own_memory = 1;  ///< bytes of its static and global variables
};

/// Reads `library`, which is to define the names listed in the file `interface_names` (mangled, one a line). Nothing if
/// the file cannot be read, by its own fault, or names too many files: a compiler's output always can. Throws
/// std::runtime_error if the inspector cannot be run.
[[nodiscard]] std::optional<Inspection> inspect(const Toolchain& tools, const std::filesystem::path& library,
                                                const std::filesystem::path& interface_names);

/// The first of `frames` (addresses in the library, return addresses but for the first) that lies in a file of
/// `folder`'s own: "sphere.cpp:17"; empty if there is none.
[[nodiscard]] std::string place_of(const Toolchain& tools, const std::filesystem::path& library,
                                   const std::vector<std::uint64_t>& frames);

/// A place in a student's file.
struct SourcePlace {
    std::string file;
    int line = 0;    ///< counted from 1
    int column = 0;  ///< in bytes, counted from 1; 0 where nothing says it

    friend auto operator<=>(const SourcePlace&, const SourcePlace&) = default;
};

/// For each of these return addresses in the library the place in a file of `folder`'s own that called, or nothing.
/// Empty if the library cannot be read, or takes longer than a student's could.
[[nodiscard]] std::vector<std::optional<SourcePlace>> places_of(const Toolchain& tools,
                                                                const std::filesystem::path& library,
                                                                std::span<const std::uint32_t> addresses);

}
