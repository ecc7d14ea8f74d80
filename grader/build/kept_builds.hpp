#pragma once

#include <filesystem>
#include <optional>

#include "build/submission.hpp"

namespace umbral::grader {

/// A build that was kept in `folder`, if it is whole; without the files that it is of.
[[nodiscard]] std::optional<Built> kept(const std::filesystem::path& folder);

/// Puts a finished build, whose library lies in `work`, in its place by renaming its folder: others see all of it or
/// nothing. Returns it as it lies there now, which is another's where that came first. Throws std::runtime_error if it
/// cannot be kept.
[[nodiscard]] Built keep(const Built& built, const std::filesystem::path& work, const std::filesystem::path& folder);

}
