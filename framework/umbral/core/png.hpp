#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <umbral/core/grid.hpp>

namespace umbral {

/// The largest picture that is read or written, in pixels: 64 Mi, 256 MiB in memory.
inline constexpr std::size_t maximum_png_pixels = std::size_t{1} << 26U;
/// The largest PNG file that is read, in bytes.
inline constexpr std::size_t maximum_png_bytes = std::size_t{1} << 29U;

/// How much work is done for a small file.
enum class Packing {
    small,  ///< for pictures that are kept
    fast,   ///< in a quarter of the time, about a quarter larger
};

/// Writes `image` as an 8-bit RGBA PNG in sRGB. The file appears whole or not at all (see write_file_atomically).
///
/// Throws std::invalid_argument for a picture without pixels (a PNG cannot hold one) or with more than
/// maximum_png_pixels, std::runtime_error with the path and the reason if the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image, Packing packing = Packing::small);

/// Reads any PNG (every bit depth, palette, grey, interlaced) as 8-bit RGBA in sRGB; a file that names no colour space
/// is taken as sRGB.
///
/// Throws std::runtime_error with the path and the reason if it is missing, not a regular file, empty, truncated,
/// damaged, no PNG, or larger than the limits above. The limits hold before memory for the pixels is taken.
[[nodiscard]] Image read_png(const std::filesystem::path& path);

/// Writes `bytes` to a new temporary file beside `path`, flushes it to the disk, and renames it to `path`.
///
/// Readers see the old file or the whole new one, never a part. Throws std::runtime_error with the path and the
/// system's reason (a full disk, a missing folder, no permission); the temporary file is then removed and an old `path`
/// is left as it was. What is no file, as /dev/null, would be replaced by one: it is refused.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

}
