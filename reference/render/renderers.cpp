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
    return {std::move(picture.frame), picture.counters};
}

Drawn by_gl(const Job& job) { return {draw_with_opengl(job.list, job.effects, job.width, job.height), {}}; }

Drawn by_fixed_function(const Job& job)
{
    return {draw_with_fixed_function(job.list, job.effects, job.width, job.height), {}};
}

Drawn with_light_at_vertices(const Job& job)
{
    return {draw_with_light_at_vertices(job.list, job.width, job.height), {}};
}

Drawn by_rays(const Job& job) { return {rays::draw_by_rays(job.list, job.width, job.height, job.effort), {}}; }

constexpr std::array<Renderer, 5> renderers = {{
    {"software", "the engine's rasteriser, light at each pixel", false, by_software},
    {"gl", "OpenGL with shaders, light at each pixel", true, by_gl},
    {"gl-fixed", "OpenGL's fixed function, light at each vertex", true, by_fixed_function},
    {"vertices", "the engine's rasteriser, light at each vertex: what gl-fixed should be", false,
     with_light_at_vertices},
    {"raytrace", "the engine's ray tracer: shadows, mirrors, glass, lenses, lights with a size, indirect light", false,
     by_rays},
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
    return renderer.draw(job);
}

}
