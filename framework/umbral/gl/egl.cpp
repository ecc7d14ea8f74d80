#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <umbral/gl/backend.hpp>

// Based on: EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context and EGL_KHR_no_config_context, Khronos EGL
// registry.
namespace umbral::gl {
namespace {

struct Library {
    decltype(&eglGetProcAddress) address_of = nullptr;
    decltype(&eglQueryString) query = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglCreateContext) create = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    decltype(&eglDestroyContext) destroy = nullptr;
    decltype(&eglGetError) error = nullptr;
    EGLDisplay display = EGL_NO_DISPLAY;
};

[[noreturn]] void fail(const Library& library, const std::string& what)
{
    char code[16];
    (void)std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(library.error()));
    throw std::runtime_error("EGL " + what + " (EGL error " + code +
                             "); Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri are needed");
}

void require(const Library& library, EGLDisplay of, const char* extension)
{
    const char* const known = library.query(of, EGL_EXTENSIONS);
    if (known == nullptr ||
        (std::string(" ") + known + " ").find(std::string(" ") + extension + " ") == std::string::npos)
        fail(library, std::string("lacks the extension ") + extension);
}

Library load_library()
{
    // Read when the driver is loaded. Never a graphics card: it would draw other pixels, and its driver does not
    // survive a fork.
    setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);

    const PrivateLibrary file(
        "EGL, which draws off screen (Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri),", {"libEGL.so.1"});
    Library egl;
    file.find("eglGetProcAddress", egl.address_of);
    file.find("eglQueryString", egl.query);
    file.find("eglInitialize", egl.initialize);
    file.find("eglBindAPI", egl.bind_api);
    file.find("eglCreateContext", egl.create);
    file.find("eglMakeCurrent", egl.make_current);
    file.find("eglDestroyContext", egl.destroy);
    file.find("eglGetError", egl.error);

    for (const char* extension : {"EGL_EXT_platform_base", "EGL_MESA_platform_surfaceless"})
        require(egl, EGL_NO_DISPLAY, extension);
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.address_of("eglGetPlatformDisplayEXT"));
    egl.display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (egl.display == EGL_NO_DISPLAY || egl.initialize(egl.display, nullptr, nullptr) == EGL_FALSE)
        fail(egl, "has no display without a screen");
    for (const char* extension : {"EGL_KHR_create_context", "EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"})
        require(egl, egl.display, extension);
    if (egl.bind_api(EGL_OPENGL_API) == EGL_FALSE) fail(egl, "knows OpenGL ES only, not OpenGL");
    return egl;
}

const Library& library()
{
    static const Library loaded = load_library();
    return loaded;
}

void load() { (void)library(); }

void* create()
{
    constexpr std::array attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                       4,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       5,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                       EGL_NONE};
    const EGLContext context =
        library().create(library().display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT)
        fail(library(), "made no context: OpenGL 4.5, compatibility profile, is needed (Mesa 21 or later)");
    return context;
}

void make_current(void* handle)
{
    const EGLContext context = handle == nullptr ? EGL_NO_CONTEXT : handle;
    if (library().make_current(library().display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
        fail(library(), "could not make its context current");
}

void destroy(void* handle) { (void)library().destroy(library().display, handle); }

EntryAddress address_of(const char* name) { return library().address_of(name); }

constexpr Backend backend{"EGL", load, create, make_current, destroy, address_of};

}

const Backend& egl_backend() { return backend; }

}
