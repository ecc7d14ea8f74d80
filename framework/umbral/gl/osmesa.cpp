#include <array>
#include <memory>
#include <stdexcept>
#include <umbral/gl/backend.hpp>
#include <umbral/gl/opengl.hpp>
#include <vector>

namespace umbral::gl {
namespace {

// The default framebuffer that OSMesa insists on; drawing goes to a gl::Framebuffer.
constexpr int default_size = 64;

// OSMesa's interface, as far as it is used: systems with Mesa 25.1 have no header of it, and still build this file.
using Handle = struct osmesa_context*;
constexpr int attribute_format = 0x22;
constexpr int attribute_depth_bits = 0x30;
constexpr int attribute_stencil_bits = 0x31;
constexpr int attribute_profile = 0x33;
constexpr int attribute_major_version = 0x36;
constexpr int attribute_minor_version = 0x37;
constexpr int compatibility_profile = 0x35;

struct Library {
    Handle (*create)(const int* attributes, Handle shared) = nullptr;
    GLboolean (*make_current)(Handle, void* pixels, GLenum type, GLsizei width, GLsizei height) = nullptr;
    void (*destroy)(Handle) = nullptr;
    EntryAddress (*address_of)(const char* name) = nullptr;
};

struct Context {
    Handle handle = nullptr;
    std::vector<unsigned char> pixels;
};

Library load_library()
{
    const PrivateLibrary library("OSMesa, which draws off screen (Debian package libosmesa6; gone from Mesa 25.1 on),",
                                 {"libOSMesa.so.8", "libOSMesa.so.6"});
    Library found;
    library.find("OSMesaCreateContextAttribs", found.create);
    library.find("OSMesaMakeCurrent", found.make_current);
    library.find("OSMesaDestroyContext", found.destroy);
    library.find("OSMesaGetProcAddress", found.address_of);
    return found;
}

const Library& library()
{
    static const Library loaded = load_library();
    return loaded;
}

void load() { (void)library(); }

void* create()
{
    constexpr std::array attributes = {attribute_format,
                                       GL_RGBA,
                                       attribute_depth_bits,
                                       24,
                                       attribute_stencil_bits,
                                       8,
                                       attribute_profile,
                                       compatibility_profile,
                                       attribute_major_version,
                                       4,
                                       attribute_minor_version,
                                       5,
                                       0};
    auto context = std::make_unique<Context>();
    context->handle = library().create(attributes.data(), nullptr);
    if (context->handle == nullptr)
        throw std::runtime_error(
            "OSMesa made no context: OpenGL 4.5, compatibility profile, is needed (Mesa 21 or later)");
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
    if (library().make_current(context->handle, context->pixels.data(), GL_UNSIGNED_BYTE, default_size, default_size) ==
        GL_FALSE)
        throw std::runtime_error("OSMesa could not make its context current");
}

void destroy(void* handle)
{
    const std::unique_ptr<Context> context(static_cast<Context*>(handle));
    library().destroy(context->handle);
}

EntryAddress address_of(const char* name) { return library().address_of(name); }

constexpr Backend backend{"OSMesa", load, create, make_current, destroy, address_of};

}

const Backend& osmesa_backend() { return backend; }

}
