#pragma once

#include <cstdint>
#include <string_view>
#include <umbral/gl/forward.hpp>

/// The application's own memory that OpenGL reads when it draws. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

/// Bytes that a draw reads from memory of the application: vertices of enabled arrays that lie in no buffer, indices
/// and commands that lie in none. Each vertex counts with its own attributes, read again or not. Asks the current
/// context.
[[nodiscard]] std::uint64_t client_bytes(std::string_view draw, const CallArguments& arguments);

/// Is a buffer bound that pictures are taken from, so that a null pointer is the buffer's beginning?
[[nodiscard]] bool unpacks_from_a_buffer();

#pragma GCC visibility pop

}
