#include "render/opengl_objects.hpp"

#include <umbral/gl/opengl.hpp>

namespace umbral::render {
namespace {

/// Makes the objects of `sources` that are needed.
template <class Object, class Source>
std::vector<std::unique_ptr<Object>> make_needed(const std::vector<Source>& sources, const std::vector<bool>& needed)
{
    std::vector<std::unique_ptr<Object>> objects(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (needed[i]) objects[i] = std::make_unique<Object>(sources[i]);
    return objects;
}

}

MeshBuffers::MeshBuffers(const VertexMesh& mesh) : count_(static_cast<int>(3 * mesh.triangles.size()))
{
    glGenVertexArrays(1, &array_);
    glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    bind();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
}

MeshBuffers::~MeshBuffers()
{
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

void MeshBuffers::bind() const
{
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
}

void MeshBuffers::draw() const
{
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

TextureObject::TextureObject(const Texture& texture)
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

TextureObject::~TextureObject() { glDeleteTextures(1, &texture_); }

void TextureObject::bind() const { glBindTexture(GL_TEXTURE_2D, texture_); }

Needed needed_objects(const DrawList& list, bool textured)
{
    Needed needed{std::vector<bool>(list.meshes.size()), std::vector<bool>(list.textures.size())};
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside) continue;
        needed.meshes[draw.mesh] = true;
        if (textured && draw.texture) needed.textures[*draw.texture] = true;
    }
    return needed;
}

DrawObjects make_objects(const DrawList& list, bool textured)
{
    const Needed needed = needed_objects(list, textured);
    return {make_needed<MeshBuffers>(list.meshes, needed.meshes),
            make_needed<TextureObject>(list.textures, needed.textures)};
}

void draw_counted(const DrawList& list, const Draw& draw, const EffectSet& effects, OpenGlWork* work,
                  const std::function<void()>& draw_it)
{
    if (work == nullptr) return draw_it();
    GLuint query = 0;
    GLuint samples = 0;
    if (work->ask_samples) {
        glGenQueries(1, &query);
        glBeginQuery(GL_SAMPLES_PASSED, query);
    }
    draw_it();
    if (work->ask_samples) {
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
        glDeleteQueries(1, &query);
    }
    const auto one_if = [](bool condition) { return condition ? std::uint64_t{1} : std::uint64_t{0}; };
    ++work->instances;
    work->vertices += list.meshes[draw.mesh].vertices.size();
    work->triangles += list.meshes[draw.mesh].triangles.size();
    work->samples += samples;
    work->textured_samples += effects.textured && draw.texture ? samples : 0;
    work->highlights += one_if(effects.specular && draw.specular);
    work->smooth += one_if(effects.smooth && draw.smooth);
    work->without_culling += one_if(draw.both_sides);
    work->crossing += one_if(draw.visibility == Visibility::crosses);
}

void count_once(const DrawList& list, const DrawObjects& objects, const EffectSet& effects, OpenGlWork* work)
{
    if (work == nullptr) return;
    for (const Draw& draw : list.draws) work->instances_outside += draw.visibility == Visibility::outside ? 1 : 0;
    for (const Light& light : list.lights) work->light_places += effects.positional && light.where.w != 0 ? 1 : 0;
    for (std::size_t i = 0; i < objects.textures.size(); ++i) {
        if (!objects.textures[i]) continue;
        ++work->textures;
        work->texels += list.textures[i].texels.cells.size();
    }
}

void set_depth_test()
{
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glCullFace(GL_BACK);
    glActiveTexture(GL_TEXTURE0);
}

void set_faces(const Draw& draw)
{
    glFrontFace(draw.mirrored ? GL_CCW : GL_CW);
    (draw.both_sides ? glDisable : glEnable)(GL_CULL_FACE);
}

}
