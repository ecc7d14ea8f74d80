#pragma once

#include <algorithm>
#include <cstdint>

/// Sizes of OpenGL's types. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

/// Bytes of one number of a type ("GL_FLOAT": 4) or of one packed value; 0 for an unknown one.
[[nodiscard]] unsigned type_size(unsigned type);

/// Bytes of one pixel; packed types hold all components at once. 0 for an unknown format or type.
[[nodiscard]] unsigned pixel_size(unsigned format, unsigned type);

/// A size that a call claims: 0 if it is negative, and no more than 1e12.
[[nodiscard]] inline std::uint64_t whole(double number)
{
    return number > 0 ? static_cast<std::uint64_t>(std::min(number, 1e12)) : 0;
}

#pragma GCC visibility pop

}
