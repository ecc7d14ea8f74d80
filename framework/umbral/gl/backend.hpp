#pragma once

#include <umbral/gl/context.hpp>
#include <umbral/gl/dispatch.hpp>

/// How an offscreen context is made by one of the libraries that can. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

/// A library that makes contexts; all functions throw std::runtime_error with what failed.
struct Backend {
    const char* name;                    ///< for people: "OSMesa"
    void (*load)();                      ///< loads the library, if that has not happened yet
    void* (*create)();                   ///< loads the library if needed; a compatibility-profile context of OpenGL 4.5
    void (*make_current)(void* handle);  ///< null releases the current one
    void (*destroy)(void* handle);
    EntryAddress (*address_of)(const char* name);
};

/// Mesa's off-screen interface, drawn by the processor (llvmpipe). Mesa 25.1 dropped it.
[[nodiscard]] const Backend& osmesa_backend();

/// Mesa's EGL without display or surface, drawn by the processor (llvmpipe).
[[nodiscard]] const Backend& egl_backend();

[[nodiscard]] const Backend& backend_of(BackendKind kind);

/// A library opened privately: its own gl functions stay out of the process's symbols. It is never closed.
class PrivateLibrary {
public:
    /// Opens the first of `files` that can be. Throws with `purpose` ("OSMesa, which …") and what dlopen says of each.
    PrivateLibrary(const char* purpose, std::initializer_list<const char*> files);

    /// Sets `function` to the library's function of that name. Throws if it has none.
    template <class Function>
    void find(const char* name, Function& function) const
    {
        function = reinterpret_cast<Function>(address(name));
    }

private:
    [[nodiscard]] void* address(const char* name) const;

    void* handle_ = nullptr;
    std::string file_;
};

#pragma GCC visibility pop

}
