#include "opengl.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

#include "mipmaps.hpp"
#include "shading.hpp"
#include "shading_text.hpp"

namespace umbral::bench::scenes {
namespace {

constexpr const char* fragment_lookup =
    "uniform sampler2D image;\nvec4 lookup(vec2 uv, float lod) { return textureLod(image, uv, lod); }\n";
constexpr const char* vertex_lookup = "vec4 lookup(vec2 uv, float lod) { return vec4(uv, lod, 1); }\n";

constexpr const char* vertex_main = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
out vec3 place_between;
out vec3 normal_between;
out vec2 uv_between;
noperspective out vec2 affine_between;
out vec4 color_between;

void main()
{
    Placed corner = placed(position, normal);
    gl_Position = vec4(corner.clip.x, -corner.clip.y, corner.clip.zw);
    place_between = corner.place;
    normal_between = corner.normal;
    uv_between = uv;
    affine_between = uv;
    color_between = color;
}
)";

constexpr const char* fragment_main = R"(
in vec3 place_between;
in vec3 normal_between;
in vec2 uv_between;
noperspective in vec2 affine_between;
in vec4 color_between;
out vec4 result;

void main()
{
    Surface at;
    at.place = place_between;
    at.normal = normal_between;
    at.uv = uv_between;
    at.affine = affine_between;
    at.color = color_between;
    vec2 right = dFdx(uv_between) * uv_scale / texel;
    vec2 down = dFdy(uv_between) * uv_scale / texel;
    at.lod = log2(max(max(dot(right, right), dot(down, down)), 1e-12)) / 2.0;
    result = shaded(at);
    if (result.a < 0.0) discard;
}
)";

std::string beginning()
{
    std::string text = "#version 330 core\n#define Real float\n#define Choice int\n#define Manner int\n";
    const auto add = [&](const auto kind) {
        text +=
            "const int " + joined(operator_of(kind).name, '_') + " = " + std::to_string(static_cast<int>(kind)) + ";\n";
    };
    for (const Flaw flaw : all_flaws()) add(flaw);
    for (const Way way : all_ways()) add(way);
    return text;
}

void set_all(const gl::Program& p, const Shading<float>& s)
{
    p.set("flaw", static_cast<int>(s.flaw));
    p.set("way", static_cast<int>(s.way));
    p.set("model", s.model);
    p.set("view", s.view);
    p.set("projection", s.projection);
    p.set("all_matrices", s.all_matrices);
    p.set("lit_in", s.lit_in);
    p.set("normal_matrix", s.normal_matrix);
    p.set("to_world", s.to_world);
    p.set("viewer", s.viewer);
    p.set("moved", s.moved);
    p.set("depth_offset", s.depth_offset);
    p.set("ambient", s.ambient);
    p.set("paint", s.paint);
    p.set("specular", s.specular);
    p.set("shininess", s.shininess);
    p.set("style", s.style);
    p.set("bands", s.bands);
    p.set("uv_scale", s.uv_scale);
    p.set("texel", s.texel);
    p.set("textured", s.textured);
    p.set("alpha_test", s.alpha_test);
    p.set("encoded", s.encoded);
    p.set("fog_color", s.fog_color);
    p.set("fog_density", s.fog_density);
    p.set("lamp_count", s.lamp_count);
    for (int i = 0; i < s.lamp_count; ++i) {
        const std::string lamp = "lamps[" + std::to_string(i) + "].";
        p.set(lamp + "place", s.lamps[i].place);
        p.set(lamp + "color", s.lamps[i].color);
        p.set(lamp + "falloff", s.lamps[i].falloff);
        p.set(lamp + "aim", s.lamps[i].aim);
        p.set(lamp + "cone", s.lamps[i].cone);
        p.set(lamp + "focus", s.lamps[i].focus);
    }
}

/// A texture that lives as long as one batch is drawn.
class BoundTexture {
public:
    explicit BoundTexture(const Texture& texture)
    {
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        const std::vector<Image> levels = level_images(texture);
        for (std::size_t i = 0; i < levels.size(); ++i)
            glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA8, levels[i].width, levels[i].height, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, levels[i].cells.data());
        const GLint wrap = texture.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
        const GLint plain = texture.linear ? GL_LINEAR : GL_NEAREST;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, plain);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, texture.mipmaps ? GL_LINEAR_MIPMAP_LINEAR : plain);
    }
    BoundTexture(const BoundTexture&) = delete;
    BoundTexture& operator=(const BoundTexture&) = delete;
    ~BoundTexture() { glDeleteTextures(1, &name_); }

private:
    GLuint name_ = 0;
};

/// Equal corners merged: the places of the corners, and which one each index means.
struct Indexed {
    std::vector<Vertex> corners;
    std::vector<std::uint32_t> indices;
};

Indexed indexed(const Triangles& triangles)
{
    Indexed mesh;
    std::map<std::array<float, 12>, std::uint32_t> known;
    for (const Vertex& v : triangles) {
        std::array<float, 12> key{};
        static_assert(sizeof key == sizeof v);
        std::memcpy(key.data(), &v, sizeof key);
        const auto [at, fresh] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.corners.size()));
        if (fresh) mesh.corners.push_back(v);
        mesh.indices.push_back(at->second);
    }
    return mesh;
}

void set_state(const Model& model, const Batch& batch)
{
    const auto enable = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    enable(GL_DEPTH_TEST, batch.depth_test);
    glDepthFunc(model.farthest_wins ? GL_GREATER : GL_LESS);
    glDepthMask(batch.depth_write ? GL_TRUE : GL_FALSE);
    enable(GL_CULL_FACE, batch.cull != Cull::none);
    glFrontFace(GL_CW);  // upside down
    glCullFace(batch.cull == Cull::front ? GL_FRONT : GL_BACK);
    enable(GL_BLEND, batch.blend != Blend::none);
    glBlendFuncSeparate(GL_SRC_ALPHA, batch.blend == Blend::add ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glLineWidth(model.line_width);
}

void send(const Batch& batch, Way way)
{
    const Indexed mesh = way == Way::indexed_mesh ? indexed(batch.corners) : Indexed{batch.corners, {}};
    std::array<GLuint, 2> buffers{};
    GLuint vertex_array = 0;
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glGenBuffers(2, buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.corners.size() * sizeof(Vertex)), mesh.corners.data(),
                 GL_STATIC_DRAW);
    constexpr auto attributes = std::to_array<std::pair<GLint, std::size_t>>({{3, offsetof(Vertex, position)},
                                                                              {3, offsetof(Vertex, normal)},
                                                                              {2, offsetof(Vertex, uv)},
                                                                              {4, offsetof(Vertex, color)}});
    for (GLuint i = 0; i < attributes.size(); ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, attributes[i].first, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(attributes[i].second));
    }
    const GLenum kind = batch.lines ? GL_LINES : GL_TRIANGLES;
    if (mesh.indices.empty()) {
        glDrawArrays(kind, 0, static_cast<GLsizei>(mesh.corners.size()));
    } else {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                     mesh.indices.data(), GL_STATIC_DRAW);
        glDrawElements(kind, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteVertexArrays(1, &vertex_array);
    glDeleteBuffers(2, buffers.data());
}

}

struct OpenGlPainter::Inside {
    explicit Inside(gl::BackendKind kind)
        : context(kind),
          program({"shading.vert", beginning() + vertex_lookup + shading_text + vertex_main},
                  {"shading.frag", beginning() + fragment_lookup + shading_text + fragment_main})
    {
    }
    gl::OffscreenContext context;
    gl::Program program;
};

OpenGlPainter::OpenGlPainter(gl::BackendKind kind) : inside_(std::make_unique<Inside>(kind)) {}

OpenGlPainter::~OpenGlPainter() { inside_->context.make_current(); }

std::string OpenGlPainter::description()
{
    inside_->context.make_current();
    return gl::backend_description();
}

Image OpenGlPainter::paint(const Model& model, Flaw flaw, Way way)
{
    inside_->context.make_current();
    const gl::Framebuffer frame(model.width, model.height);
    frame.clear(model.background);
    if (model.farthest_wins) {
        glClearDepth(0);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
    for (const Batch& batch : model.batches) {
        if (batch.corners.empty()) continue;
        Shading<float> shading{};
        prepare(shading, model, batch, flaw, way);
        std::unique_ptr<BoundTexture> texture;
        if (batch.texture) texture = std::make_unique<BoundTexture>(model.textures.at(*batch.texture));
        set_all(inside_->program, shading);
        set_state(model, batch);
        send(batch, way);
    }
    gl::check_errors("drawing a scene");
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    Image image = frame.read_pixels();
    // Read bottom row first, and so upright again.
    for (int y = 0; y < image.height / 2; ++y)
        std::swap_ranges(&image.at(0, y), &image.at(0, y) + image.width, &image.at(0, image.height - 1 - y));
    for (glm::u8vec4& pixel : image.cells) pixel.a = 255;
    return image;
}

}
