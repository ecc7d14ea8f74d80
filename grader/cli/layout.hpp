#pragma once

#include <filesystem>

namespace umbral::grader {

/// Where the files of this Umbral lie. Nothing of it is compiled in: the program looks where it lies itself, so that an
/// installation can be moved to any prefix, and holds no path of whoever built it.
struct Layout {
    bool installed = false;       ///< below a prefix, and not in a checkout: nothing can be built there
    std::filesystem::path build;  ///< bin, lib, units below it: the build folder, or PREFIX/lib/umbral
    std::filesystem::path
        data;  ///< exercises, framework, perhaps reference below it: the checkout, or PREFIX/share/umbral
    std::filesystem::path samples;   ///< the sample class; missing in students' packages
    std::filesystem::path attacks;   ///< what `umbral doctor --attack` hands in; missing in students' packages
    std::filesystem::path includes;  ///< the header before students' first line
};

/// The layout around a program at `program`, a path without links: `checkout.txt` in the folder above its own names the
/// checkout that this is the build of; without it, that folder must be PREFIX/lib/umbral. Throws std::runtime_error
/// that says what was expected where.
[[nodiscard]] Layout layout_around(const std::filesystem::path& program);

/// The layout around the program that runs. Throws std::runtime_error.
[[nodiscard]] Layout own_layout();

}
