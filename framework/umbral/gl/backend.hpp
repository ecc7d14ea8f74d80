#pragma once

#include <umbral/gl/dispatch.hpp>

/// How an offscreen context is made by one of the libraries that can. Private to libumbral-gl.
namespace umbral::gl {

/// A library that makes contexts; all functions throw std::runtime_error with what failed.
struct Backend {
    void* (*create)();                   ///< loads the library if needed; a compatibility-profile context of OpenGL 4.5
    void (*make_current)(void* handle);  ///< null releases the current one
    void (*destroy)(void* handle);
    EntryAddress (*address_of)(const char* name);
};

/// Mesa's off-screen interface, drawn by the processor (llvmpipe).
[[nodiscard, gnu::visibility("hidden")]] const Backend& osmesa_backend();

}
