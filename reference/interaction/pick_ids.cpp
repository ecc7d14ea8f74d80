// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Compatibility Profile).
// 2017, chapters 9 (framebuffers and framebuffer objects), 18.2 (reading pixels) and 21.7 (saving and restoring state).

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <umbral/gl/opengl.hpp>
#include <umbral/interaction/pick_ids.hpp>

namespace umbral::interaction {
namespace {

GLuint bound(GLenum binding)
{
    GLint name = 0;
    glGetIntegerv(binding, &name);
    return static_cast<GLuint>(name);
}

/// Puts back, at the end of its life, all state that drawing ids changes.
class SavedState {
public:
    SavedState()
        : draw_(bound(GL_DRAW_FRAMEBUFFER_BINDING)),
          read_(bound(GL_READ_FRAMEBUFFER_BINDING)),
          renderbuffer_(bound(GL_RENDERBUFFER_BINDING)),
          program_(bound(GL_CURRENT_PROGRAM))
    {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
        for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
            glMatrixMode(mode);
            glPushMatrix();
        }
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;
    ~SavedState()
    {
        // The framebuffers first: what is popped names a buffer of the one that is bound.
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw_);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, read_);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
        glUseProgram(program_);
        for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
            glMatrixMode(mode);
            glPopMatrix();
        }
        glPopClientAttrib();
        glPopAttrib();
    }

private:
    GLuint draw_;
    GLuint read_;
    GLuint renderbuffer_;
    GLuint program_;
};

/// From now on a pixel gets the bytes of the current colour, and the nearest triangle's.
void set_plain_drawing()
{
    glUseProgram(0);
    for (const GLenum what : {GL_LIGHTING, GL_TEXTURE_2D, GL_FOG, GL_BLEND, GL_ALPHA_TEST, GL_DITHER, GL_SCISSOR_TEST,
                              GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CULL_FACE})
        glDisable(what);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0, 1);
}

void draw(const PickMesh& mesh)
{
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
}

void draw(const PickScene& scene)
{
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(scene.projection));
    glMatrixMode(GL_MODELVIEW);
    for (const PickThing& thing : scene.things) {
        if (thing.id == 0) continue;
        const glm::mat4 modelview = scene.view * thing.model;
        glLoadMatrixf(glm::value_ptr(modelview));
        const glm::u8vec3 color = color_of_id(thing.id);
        glColor3ub(color.r, color.g, color.b);
        draw(scene.meshes[thing.mesh]);
    }
}

/// A colour buffer of three bytes and more a pixel, and a depth buffer, that no window shows.
class FramebufferPicker : public IdPicker {
public:
    FramebufferPicker() = default;
    FramebufferPicker(const FramebufferPicker&) = delete;
    FramebufferPicker& operator=(const FramebufferPicker&) = delete;
    ~FramebufferPicker() override { destroy(); }

    Grid<std::uint32_t> ids_around(const PickScene& scene, const glm::ivec2& picture, const glm::ivec2& pixel,
                                   int radius) override
    {
        const SavedState saved;
        if (picture != size_) {
            destroy();
            create(picture);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glViewport(0, 0, size_.x, size_.y);
        set_plain_drawing();
        glClearColor(0, 0, 0, 0);
        glClearDepth(1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw(scene);
        return read_square(pixel, radius);
    }

private:
    void create(const glm::ivec2& size)
    {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        create_buffer(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, size);
        create_buffer(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, size);
        size_ = size;
    }

    static void create_buffer(GLuint& name, GLenum format, GLenum attachment, const glm::ivec2& size)
    {
        glGenRenderbuffers(1, &name);
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    }

    void destroy()
    {
        if (size_.x == 0) return;
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(1, &color_);
        glDeleteRenderbuffers(1, &depth_);
    }

    /// From the framebuffer that is bound. Only pixels that it has are read: others would be undefined.
    [[nodiscard]] Grid<std::uint32_t> read_square(const glm::ivec2& pixel, int radius) const
    {
        Grid<std::uint32_t> ids(2 * radius + 1, 2 * radius + 1);
        const glm::ivec2 corner = pixel - radius;
        const glm::ivec2 low = glm::max(corner, 0);
        const glm::ivec2 high = glm::min(pixel + radius + 1, size_);
        if (low.x >= high.x || low.y >= high.y) return ids;
        const glm::ivec2 block = high - low;
        // Four bytes a pixel: rows need no padding, whatever GL_PACK_ALIGNMENT is. OpenGL counts rows from below.
        Grid<glm::u8vec4> colors(block.x, block.y);
        glReadPixels(low.x, size_.y - high.y, block.x, block.y, GL_RGBA, GL_UNSIGNED_BYTE, colors.cells.data());
        for (int row = 0; row < block.y; ++row)
            for (int column = 0; column < block.x; ++column)
                ids.at(low.x - corner.x + column, low.y - corner.y + row) =
                    id_of_color(glm::u8vec3(colors.at(column, block.y - 1 - row)));
        return ids;
    }

    glm::ivec2 size_{0};  // of the objects; 0 while there are none
    GLuint framebuffer_ = 0;
    GLuint color_ = 0;
    GLuint depth_ = 0;
};

}

glm::u8vec3 color_of_id(std::uint32_t id)
{
    if (id >= 1U << 24U)
        throw std::invalid_argument("color_of_id: expected an id below 2^24, got " + std::to_string(id));
    return {id & 0xFFU, (id >> 8U) & 0xFFU, id >> 16U};
}

std::uint32_t id_of_color(const glm::u8vec3& color)
{
    return color.r + (std::uint32_t{color.g} << 8U) + (std::uint32_t{color.b} << 16U);
}

std::unique_ptr<IdPicker> make_id_picker() { return std::make_unique<FramebufferPicker>(); }

std::uint32_t nearest_id(const Grid<std::uint32_t>& ids)
{
    const int middle = ids.width / 2;
    std::uint32_t nearest = 0;
    int least = std::numeric_limits<int>::max();
    for (int row = 0; row < ids.height; ++row)
        for (int column = 0; column < ids.width; ++column) {
            const int right = column - middle;
            const int down = row - middle;
            const int square = right * right + down * down;
            if (ids.at(column, row) == 0 || square >= least) continue;
            least = square;
            nearest = ids.at(column, row);
        }
    return nearest;
}

}
