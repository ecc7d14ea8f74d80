#include "painters.hpp"

#include <stdexcept>

namespace umbral::bench::scenes {
namespace {

bool machine_fuses()
{
#ifdef UMBRAL_HAS_FUSED
    return __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

bool has_other_compiler()
{
#ifdef UMBRAL_HAS_OTHER_COMPILER
    return true;
#else
    return false;
#endif
}

std::unique_ptr<OpenGlPainter> other_painter(gl::BackendKind kind)
{
    try {
        return std::make_unique<OpenGlPainter>(kind == gl::BackendKind::osmesa ? gl::BackendKind::egl
                                                                               : gl::BackendKind::osmesa);
    } catch (const std::runtime_error&) {
        return nullptr;  // this machine has one only
    }
}

}

Painters::Painters(gl::BackendKind kind) : main_(kind), other_(other_painter(kind)) {}

Image Painters::opengl(const Model& model, Flaw flaw, Way way)
{
    return (way == Way::other_gl_back_end && other_ ? *other_ : main_).paint(model, flaw, way);
}

SoftwareBuild Painters::software(Way way)
{
    switch (way) {
        case Way::not_optimised: return not_optimised::build();
        case Way::double_precision: return in_double::build();
#ifdef UMBRAL_HAS_FUSED
        case Way::fused_multiply_add: return fused::build();
#endif
#ifdef UMBRAL_HAS_OTHER_COMPILER
        case Way::other_compiler: return other_compiler::build();
#endif
        default: return plain::build();
    }
}

render::Frame Painters::engine(const std::string& renderer, const render::Job& job)
{
    return studio_.draw(render::renderer_named(renderer), job).frame;
}

bool Painters::has(Way way) const
{
    if (way == Way::other_gl_back_end) return other_ != nullptr;
    if (way == Way::fused_multiply_add) return machine_fuses();
    if (way == Way::other_compiler) return has_other_compiler();
    return true;
}

}
