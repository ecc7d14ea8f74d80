#include <dlfcn.h>

#include <GL/osmesa.h>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <umbral/gl/backend.hpp>
#include <vector>

namespace umbral::gl {
namespace {

// The default framebuffer that OSMesa insists on; drawing goes to a gl::Framebuffer.
constexpr int default_size = 64;

struct Library {
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaGetProcAddress) address_of = nullptr;
};

struct Context {
    OSMesaContext handle = nullptr;
    std::vector<unsigned char> pixels;
};

template <class Function>
void find(void* library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) throw std::runtime_error(std::string("OSMesa was loaded but has no function ") + name + ": install Mesa 17 or later");
}

/// Loads the library privately: its own gl functions stay out of the process's symbols. It is never unloaded.
Library load_library()
{
    std::string errors;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"}) {
        void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) {
            errors += std::string("\n  ") + dlerror();
            continue;
        }
        Library found;
        find(library, "OSMesaCreateContextAttribs", found.create);
        find(library, "OSMesaMakeCurrent", found.make_current);
        find(library, "OSMesaDestroyContext", found.destroy);
        find(library, "OSMesaGetProcAddress", found.address_of);
        return found;
    }
    throw std::runtime_error("OSMesa, which draws off screen, could not be loaded (Debian package libosmesa6):" + errors);
}

const Library& library()
{
    static const Library loaded = load_library();
    return loaded;
}

void* create()
{
    constexpr std::array attributes = {OSMESA_FORMAT,
                                       int{OSMESA_RGBA},
                                       OSMESA_DEPTH_BITS,
                                       24,
                                       OSMESA_STENCIL_BITS,
                                       8,
                                       OSMESA_PROFILE,
                                       OSMESA_COMPAT_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       4,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       5,
                                       0};
    auto context = std::make_unique<Context>();
    context->handle = library().create(attributes.data(), nullptr);
    if (context->handle == nullptr) throw std::runtime_error("OSMesa made no context: OpenGL 4.5, compatibility profile, is needed (Mesa 21 or later)");
    context->pixels.resize(std::size_t{4} * default_size * default_size);
    return context.release();
}

void make_current(void* handle)
{
    if (handle == nullptr) {
        (void)library().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        return;
    }
    auto* context = static_cast<Context*>(handle);
    if (library().make_current(context->handle, context->pixels.data(), GL_UNSIGNED_BYTE, default_size, default_size) == GL_FALSE)
        throw std::runtime_error("OSMesa could not make its context current");
}

void destroy(void* handle)
{
    const std::unique_ptr<Context> context(static_cast<Context*>(handle));
    library().destroy(context->handle);
}

EntryAddress address_of(const char* name) { return library().address_of(name); }

constexpr Backend backend{create, make_current, destroy, address_of};

}

const Backend& osmesa_backend() { return backend; }

}
