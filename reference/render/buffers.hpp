#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/frame.hpp"

namespace umbral::render {

/// Writes the buffers of a frame into `folder`, which is made if it is not there: color.npy (linear, 4 floats a pixel),
/// depth.npy (float), ids.npy (32-bit unsigned), coverage.npy (bytes, 0 or 1), top row first, as NumPy reads them; and
/// depth.png, ids.png, coverage.png to look at. Throws std::runtime_error with path and reason.
void write_buffers(const std::filesystem::path& folder, const Frame& frame);

/// A file of NumPy's format 1.0: `type` is its name there, "<f4" for little-endian floats; `shape` from the outermost
/// dimension inwards.
[[nodiscard]] std::vector<std::byte> npy_bytes(const std::string& type, const std::vector<int>& shape,
                                               std::span<const std::byte> data);

}
