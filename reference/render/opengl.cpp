#include "render/opengl.hpp"

#include <cstddef>
#include <span>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

#include "render/opengl_objects.hpp"
#include "render/opengl_shaders.hpp"
#include "render/opengl_target.hpp"

namespace umbral::render {
namespace {

void feed(const gl::Program& program, const char* name, int components, std::size_t offset)
{
    const int location = program.attribute_location(name);
    if (location < 0) return;
    glEnableVertexAttribArray(static_cast<GLuint>(location));
    glVertexAttribPointer(static_cast<GLuint>(location), components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offset));
}

void draw_mesh(const MeshBuffers& mesh, const gl::Program& program)
{
    mesh.bind();
    feed(program, "position", 3, offsetof(Vertex, position));
    feed(program, "normal", 3, offsetof(Vertex, normal));
    feed(program, "uv", 2, offsetof(Vertex, uv));
    mesh.draw();
}

void set_once(const gl::Program& program, const DrawList& list)
{
    std::vector<glm::vec4> where;
    std::vector<glm::vec3> color;
    for (const Light& light : list.lights) {
        where.push_back(light.where);
        color.push_back(light.color);
    }
    program.set("projection", list.projection);
    program.set("global_ambient", list.ambient);
    program.set("image", 0);
    if (list.lights.empty()) return;
    program.set("light_where", std::span<const glm::vec4>(where));
    program.set("light_color", std::span<const glm::vec3>(color));
}

void set_for(const gl::Program& program, const Draw& draw)
{
    program.set("model_view", draw.model_view);
    program.set("normal_matrix", draw.normal_matrix);
    program.set("emission", draw.material.emission);
    program.set("material_ambient", draw.material.ambient);
    program.set("material_diffuse", draw.material.diffuse);
    program.set("specular", draw.material.specular);
    program.set("exponent", draw.material.exponent);
    program.set("texture_scale", draw.material.texture_scale);
    program.set("is_textured", draw.texture ? 1 : 0);
    program.set("is_smooth", draw.smooth ? 1 : 0);
    program.set("id", static_cast<int>(draw.id));
}

void draw_all(const DrawList& list, const EffectSet& effects, const gl::Program& program, OpenGlWork* work)
{
    const DrawObjects objects = make_objects(list, effects.textured);
    count_once(list, objects, effects, work);
    set_once(program, list);
    set_depth_test();
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside) continue;
        set_for(program, draw);
        if (draw.texture && objects.textures[*draw.texture]) objects.textures[*draw.texture]->bind();
        set_faces(draw);
        draw_counted(list, draw, effects, work, [&] { draw_mesh(*objects.meshes[draw.mesh], program); });
    }
}

}

Frame draw_with_opengl(const DrawList& list, const EffectSet& effects, int width, int height, OpenGlWork* work)
{
    const OpenGlTarget target(width, height);
    const ShaderTexts texts = shaders_for(effects, list.lights.size());
    const gl::Program program({"engine.vert", texts.vertex}, {"engine.frag", texts.fragment});
    draw_all(list, effects, program, work);
    gl::check_errors("drawing the scene");
    return target.read();
}

}
