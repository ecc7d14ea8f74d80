#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// What a finished run of trusted code recorded, as it lies on the disk, so that it need not be run again.
struct KeptRun {
    std::map<std::string, Tensor, std::less<>> tensors;
    struct Times {
        double cpu_seconds = 0;
        double wall_seconds = 0;
    } times{};
};

/// Writes it to `file`, whole or not at all. Throws std::runtime_error with path and reason.
void keep_run(const std::filesystem::path& file, const KeptRun& run);

/// Reads it; nothing if the file is missing, damaged in any bit, or of another version. Never throws.
[[nodiscard]] std::optional<KeptRun> kept_run(const std::filesystem::path& file) noexcept;

}
