#include "render/opengl.hpp"

#include <cstddef>
#include <deque>
#include <span>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

#include "render/opengl_shaders.hpp"
#include "render/opengl_target.hpp"

namespace umbral::render {
namespace {

/// A mesh in the memory of the graphics card.
class Buffers {
public:
    explicit Buffers(const VertexMesh& mesh) : count_(static_cast<GLsizei>(3 * mesh.triangles.size()))
    {
        glGenVertexArrays(1, &array_);
        glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                     mesh.vertices.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3)),
                     mesh.triangles.data(), GL_STATIC_DRAW);
    }
    Buffers(const Buffers&) = delete;
    Buffers& operator=(const Buffers&) = delete;
    ~Buffers()
    {
        glDeleteVertexArrays(1, &array_);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }

    void draw(const gl::Program& program) const
    {
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        feed(program, "position", 3, offsetof(Vertex, position));
        feed(program, "normal", 3, offsetof(Vertex, normal));
        feed(program, "uv", 2, offsetof(Vertex, uv));
        glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
        glBindVertexArray(0);
    }

private:
    static void feed(const gl::Program& program, const char* name, int components, std::size_t offset)
    {
        const int location = program.attribute_location(name);
        if (location < 0) return;
        glEnableVertexAttribArray(static_cast<GLuint>(location));
        glVertexAttribPointer(static_cast<GLuint>(location), components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    }

    GLsizei count_;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{};
};

class TextureObject {
public:
    explicit TextureObject(const Texture& texture)
    {
        // OpenGL's first row is the lowest.
        const Grid<glm::vec4>& texels = texture.texels;
        std::vector<glm::vec4> upwards;
        upwards.reserve(texels.cells.size());
        for (int y = texels.height - 1; y >= 0; --y)
            upwards.insert(upwards.end(), &texels.at(0, y), &texels.at(0, y) + texels.width);

        const GLint filter = texture.sampler.filter == texturing::Filter::nearest ? GL_NEAREST : GL_LINEAR;
        const auto mode = [](texturing::Wrap wrap) {
            return wrap == texturing::Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
        };
        glGenTextures(1, &texture_);
        bind();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texels.width, texels.height, 0, GL_RGBA, GL_FLOAT, upwards.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode(texture.sampler.wrap_u));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode(texture.sampler.wrap_v));
    }
    TextureObject(const TextureObject&) = delete;
    TextureObject& operator=(const TextureObject&) = delete;
    ~TextureObject() { glDeleteTextures(1, &texture_); }

    void bind() const { glBindTexture(GL_TEXTURE_2D, texture_); }

private:
    GLuint texture_ = 0;
};

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

void draw_all(const DrawList& list, const gl::Program& program)
{
    const std::deque<Buffers> meshes(list.meshes.begin(), list.meshes.end());
    const std::deque<TextureObject> textures(list.textures.begin(), list.textures.end());
    set_once(program, list);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glCullFace(GL_BACK);
    glActiveTexture(GL_TEXTURE0);
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside) continue;
        set_for(program, draw);
        if (draw.texture) textures[*draw.texture].bind();
        glFrontFace(draw.mirrored ? GL_CCW : GL_CW);  // the shader turns pictures upside down
        (draw.both_sides ? glDisable : glEnable)(GL_CULL_FACE);
        meshes[draw.mesh].draw(program);
    }
}

}

Frame draw_with_opengl(const DrawList& list, const EffectSet& effects, int width, int height)
{
    const OpenGlTarget target(width, height);
    const ShaderTexts texts = shaders_for(effects, list.lights.size());
    const gl::Program program({"engine.vert", texts.vertex}, {"engine.frag", texts.fragment});
    draw_all(list, program);
    gl::check_errors("drawing the scene");
    return target.read();
}

}
