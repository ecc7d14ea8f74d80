#include <cstdlib>
#include <stdexcept>
#include <umbral/gl/backend.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>

namespace umbral::gl {
namespace {

OffscreenContext* current = nullptr;
const Backend* current_backend = nullptr;

std::string text_of(GLenum name)
{
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

const char* error_name(GLenum error)
{
    switch (error) {
        case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
        case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
        case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
        case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
        case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
        default: return "an unknown error";
    }
}

}

void forbid_driver_threads()
{
    setenv("LP_NUM_THREADS", "0", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

OffscreenContext::OffscreenContext(BackendKind kind) : backend_(&backend_of(kind)), handle_(backend_->create())
{
    make_current();
}

OffscreenContext::~OffscreenContext()
{
    // Destroying with drawing still pending crashes in OSMesa: the context has to be current to finish it.
    OffscreenContext* const previous = current;
    if (previous != this) make_current();
    glFinish();
    disconnect();
    backend_->make_current(nullptr);
    backend_->destroy(handle_);
    current = nullptr;
    if (previous != nullptr && previous != this) previous->make_current();
}

void OffscreenContext::make_current()
{
    // Each back end only knows of its own contexts: the other's has to be let go of by itself.
    if (current != nullptr && current_backend != backend_) current_backend->make_current(nullptr);
    backend_->make_current(handle_);
    connect(backend_->address_of);
    current = this;
    current_backend = backend_;
}

bool OffscreenContext::is_current() const noexcept { return current == this; }

bool has_context() noexcept { return current != nullptr; }

std::string backend_description()
{
    if (!has_context())
        throw std::logic_error("gl::backend_description: no context is current; make a gl::OffscreenContext first");
    return std::string(current_backend->name) + ": " + text_of(GL_VERSION) + "; " + text_of(GL_RENDERER);
}

void check_errors(const std::string& where)
{
    std::string names;
    // Bounded, since a lost context may report errors for ever.
    for (int i = 0; i < 16; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        names += (names.empty() ? "" : ", ") + std::string(error_name(error));
    }
    if (!names.empty()) throw std::runtime_error("OpenGL reports " + names + " after " + where);
}

}
