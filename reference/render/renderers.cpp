#include "render/renderers.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "render/opengl.hpp"
#include "render/opengl_fixed.hpp"
#include "render/software.hpp"
#include "render/vertex_light.hpp"

namespace umbral::render {
namespace {

Drawn by_software(const Job& job)
{
    SoftwarePicture picture = draw_in_software(job.list, job.effects, job.width, job.height);
    return {std::move(picture.frame), counts_of(picture.counters)};
}

template <class Draw>
Drawn by_opengl(const Job& job, const Draw& draw)
{
    OpenGlWork work{.ask_samples = true};
    Frame frame = draw(job.list, job.effects, job.width, job.height, job.count ? &work : nullptr);
    return {std::move(frame), job.count ? counts_of(work) : std::vector<Count>()};
}

Drawn by_gl(const Job& job) { return by_opengl(job, draw_with_opengl); }

Drawn by_fixed_function(const Job& job) { return by_opengl(job, draw_with_fixed_function); }

Drawn with_light_at_vertices(const Job& job)
{
    return {draw_with_light_at_vertices(job.list, job.width, job.height), {}};
}

Drawn by_rays(const Job& job)
{
    rays::RayCounts counts;
    Frame frame = rays::draw_by_rays(job.list, job.width, job.height, job.effort, &counts);
    return {std::move(frame), rays::counts_of(counts)};
}

constexpr std::array<Renderer, 5> renderers = {{
    {"software", "the engine's rasteriser, light at each pixel",
     "each effect is a compile-time flag of a kernel; 64 sets are made of 16 kernels for fragments and 4 for triangles",
     false, by_software},
    {"gl", "OpenGL with shaders, light at each pixel",
     "each effect is a name that the shaders define or not; their text is made for the scene", true, by_gl},
    {"gl-fixed", "OpenGL's fixed function, light at each vertex",
     "textures, highlights and second sides are state that is set or not; the others cost nothing, as light is "
     "computed "
     "at vertices, and OpenGL clips in any case",
     true, by_fixed_function},
    {"vertices", "the engine's rasteriser, light at each vertex: what gl-fixed should be",
     "none is: it always has all of them", false, with_light_at_vertices},
    {"raytrace",
     "the engine's ray tracer: shadows, mirrors, glass, bump maps, lenses, lights with a size, indirect light",
     "rays of an effect are followed only from where a material, a light or the camera asks for them", false, by_rays,
     true},
}};

}

std::span<const Renderer> all_renderers() { return renderers; }

const Renderer& renderer_named(const std::string& name)
{
    const auto* found =
        std::ranges::find_if(renderers, [&](const Renderer& one) { return one.name == std::string_view(name); });
    if (found == renderers.end()) throw std::invalid_argument("no renderer is called " + name);
    return *found;
}

Drawn Studio::draw(const Renderer& renderer, const Job& job)
{
    if (renderer.needs_opengl && !context_) {
        gl::forbid_driver_threads();
        context_.emplace();
    }
    if (renderer.needs_opengl) context_->make_current();
    return renderer.draw(job);
}

}
