#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <umbral/gl/backend.hpp>

namespace umbral::gl {

const Backend& backend_of(BackendKind kind)
{
    switch (kind) {
        case BackendKind::osmesa: return osmesa_backend();
        case BackendKind::egl: return egl_backend();
    }
    throw std::invalid_argument("OffscreenContext: unknown back end " + std::to_string(static_cast<int>(kind)));
}

BackendKind default_backend()
{
    const char* const chosen = std::getenv("UMBRAL_GL");
    if (chosen != nullptr && *chosen != 0) {
        if (const auto kind = backend_named(chosen)) return *kind;
        throw std::runtime_error("UMBRAL_GL is '" + std::string(chosen) +
                                 "': expected osmesa or egl, or unset the variable");
    }
    std::string errors;
    for (const BackendKind kind : {BackendKind::osmesa, BackendKind::egl}) {
        try {
            backend_of(kind).load();
            return kind;
        } catch (const std::runtime_error& error) {
            errors += std::string("\n") + error.what();
        }
    }
    throw std::runtime_error("nothing here draws without a window: neither OSMesa nor EGL can be loaded" + errors);
}

PrivateLibrary::PrivateLibrary(const char* purpose, std::initializer_list<const char*> files)
{
    std::string errors;
    for (const char* file : files) {
        handle_ = dlopen(file, RTLD_NOW | RTLD_LOCAL);
        file_ = file;
        if (handle_ != nullptr) return;
        errors += std::string("\n  ") + dlerror();
    }
    throw std::runtime_error(std::string(purpose) + " could not be loaded:" + errors);
}

void* PrivateLibrary::address(const char* name) const
{
    void* const found = dlsym(handle_, name);
    if (found == nullptr)
        throw std::runtime_error(file_ + " was loaded but has no function " + name + ": install a newer Mesa");
    return found;
}

}
