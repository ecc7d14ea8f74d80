#pragma once

#include <string>
#include <umbral/core/grid.hpp>

#include "report/html/markup.hpp"

namespace umbral::grader::html {

/// A picture as a PNG file in memory.
struct Picture {
    int width = 0;
    int height = 0;
    std::string png;
};

/// Encodes a picture without loss in few bytes: with a palette where 256 colours do, without alpha where all is opaque.
/// An empty picture stays empty. Throws std::runtime_error if the picture cannot be encoded.
[[nodiscard]] Picture encode(const Image& image);

/// "data:image/png;base64,…" for an attribute.
[[nodiscard]] Markup data_url(const Picture& picture);

}
