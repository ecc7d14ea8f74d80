#pragma once

#include <array>
#include <glm/glm.hpp>
#include <kit/gl_state.hpp>
#include <umbral/core/random.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

/// OpenGL's state round a pick: what stands there before, and what is read afterwards.
namespace umbral::interaction {

inline bool coin(Random& random) { return random.below(2) == 0; }

/// Two pictures that others draw into and read from, a program and a texture of theirs.
class OthersWork {
public:
    OthersWork()
        : program_(
              {"others.vert", "#version 330 core\nin vec3 place;\nvoid main() { gl_Position = vec4(place, 1); }\n"},
              {"others.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1, 0, 0, 1); }\n"}),
          first_(size, size),
          second_(size, size)
    {
        first_.clear(fill);
        second_.clear(fill);
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        const std::array<unsigned char, 4> dark = {20, 40, 30, 90};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, dark.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glGenRenderbuffers(1, &renderbuffer_);
    }
    OthersWork(const OthersWork&) = delete;
    OthersWork& operator=(const OthersWork&) = delete;
    ~OthersWork()
    {
        glUseProgram(0);
        glDeleteTextures(1, &texture_);
        glDeleteRenderbuffers(1, &renderbuffer_);
    }

    /// Leaves all that a pick must not rely on as nobody can have expected it.
    void disturb(Random& random) const
    {
        // Binding either picture sets both bindings, and the names are its own.
        const bool turned = coin(random);
        (turned ? first_ : second_).bind();
        GLint other = 0;
        glGetIntegerv(GL_FRAMEBUFFER_BINDING, &other);
        (turned ? second_ : first_).bind();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(other));
        glBindRenderbuffer(GL_RENDERBUFFER, coin(random) ? renderbuffer_ : 0);
        glUseProgram(0);
        if (coin(random)) program_.use();
        glBindTexture(GL_TEXTURE_2D, texture_);
        const auto small = [&] { return 1 + static_cast<int>(random.below(6)); };
        const int corner = small();
        const int size_of_it = small();
        glViewport(corner, 1, size_of_it, 3);
        glScissor(1, corner, 2, size_of_it);
        for (const GLenum what : {GL_LIGHTING, GL_TEXTURE_2D, GL_FOG, GL_BLEND, GL_ALPHA_TEST, GL_DITHER,
                                  GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST})
            coin(random) ? glEnable(what) : glDisable(what);
        disturb_functions(random);
        disturb_matrices(random);
    }

    /// How many pixels of the two pictures have another colour than before.
    [[nodiscard]] float changed_pixels() const
    {
        const glm::u8vec4 before(glm::round(255.0F * fill));
        float changed = 0;
        for (const gl::Framebuffer* picture : {&first_, &second_})
            for (const glm::u8vec4& pixel : picture->read_pixels().cells) changed += pixel == before ? 0.0F : 1.0F;
        return changed;
    }

private:
    static constexpr int size = 12;
    static constexpr glm::vec4 fill{0.2F, 0.4F, 0.6F, 1};

    static void disturb_functions(Random& random)
    {
        constexpr std::array comparisons = {GL_NEVER, GL_LESS, GL_GREATER, GL_GEQUAL, GL_ALWAYS};
        const auto comparison = [&] { return static_cast<GLenum>(comparisons[random.below(5)]); };
        glDepthFunc(comparison());
        glAlphaFunc(comparison(), 0.5F);
        glStencilFunc(comparison(), 1, 1);
        glDepthMask(coin(random) ? GL_TRUE : GL_FALSE);
        coin(random) ? glDepthRange(0.75, 0.25) : glDepthRange(0, 0.5);
        glClearDepth(coin(random) ? 0.0 : 0.25);
        glClearColor(random.uniform(), random.uniform(), random.uniform(), random.uniform());
        const auto flag = [&] { return static_cast<GLboolean>(coin(random) ? GL_TRUE : GL_FALSE); };
        const GLboolean red = flag();
        const GLboolean green = flag();
        glColorMask(red, green, flag(), GL_TRUE);
        glShadeModel(coin(random) ? GL_FLAT : GL_SMOOTH);
        glPolygonMode(GL_FRONT_AND_BACK, coin(random) ? GL_LINE : GL_FILL);
        glCullFace(coin(random) ? GL_FRONT : GL_BACK);
        glFrontFace(coin(random) ? GL_CW : GL_CCW);
        glBlendFunc(GL_ONE, GL_ONE);
        glLogicOp(GL_INVERT);
        glFogf(GL_FOG_DENSITY, 2);
        glColor4f(random.uniform(), random.uniform(), random.uniform(), 0.25F);
    }

    static void disturb_matrices(Random& random)
    {
        for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION}) {
            glMatrixMode(mode);
            std::array<float, 16> numbers{};
            for (float& number : numbers) number = random.uniform(-1, 1);
            glLoadMatrixf(numbers.data());
        }
        constexpr std::array modes = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
        glMatrixMode(static_cast<GLenum>(modes[random.below(3)]));
    }

    gl::Program program_;
    gl::Framebuffer first_;
    gl::Framebuffer second_;
    GLuint texture_ = 0;
    GLuint renderbuffer_ = 0;
};

inline constexpr const char* state_columns =
    "GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_RENDERBUFFER_BINDING, GL_CURRENT_PROGRAM, "
    "GL_TEXTURE_BINDING_2D, GL_LIGHTING, GL_TEXTURE_2D, GL_FOG, GL_BLEND, GL_ALPHA_TEST, GL_DITHER, GL_SCISSOR_TEST, "
    "GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, "
    "GL_SHADE_MODEL, GL_MATRIX_MODE, GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_ATTRIB_STACK_DEPTH, "
    "GL_VERTEX_ARRAY, GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_PACK_ALIGNMENT, GL_CULL_FACE_MODE, "
    "GL_FRONT_FACE, "
    "GL_ALPHA_TEST_FUNC, GL_STENCIL_FUNC, GL_BLEND_SRC, GL_BLEND_DST, GL_LOGIC_OP_MODE, GL_VIEWPORT/4, "
    "GL_SCISSOR_BOX/4, "
    "GL_COLOR_WRITEMASK/4, "
    "GL_POLYGON_MODE/2, GL_COLOR_CLEAR_VALUE/4, GL_DEPTH_CLEAR_VALUE, GL_DEPTH_RANGE/2, GL_CURRENT_COLOR/4, "
    "GL_MODELVIEW_MATRIX/16, GL_PROJECTION_MATRIX/16, glGetError";

inline std::vector<float> state_row()
{
    std::vector<float> row;
    const auto append = [&](GLenum name, std::size_t count) {
        std::array<float, 16> numbers{};
        glGetFloatv(name, numbers.data());
        row.insert(row.end(), numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (const GLenum name : {GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_RENDERBUFFER_BINDING,
                              GL_CURRENT_PROGRAM,
                              GL_TEXTURE_BINDING_2D,
                              GL_LIGHTING,
                              GL_TEXTURE_2D,
                              GL_FOG,
                              GL_BLEND,
                              GL_ALPHA_TEST,
                              GL_DITHER,
                              GL_SCISSOR_TEST,
                              GL_STENCIL_TEST,
                              GL_COLOR_LOGIC_OP,
                              GL_CULL_FACE,
                              GL_DEPTH_TEST,
                              GL_DEPTH_FUNC,
                              GL_DEPTH_WRITEMASK,
                              GL_SHADE_MODEL,
                              GL_MATRIX_MODE,
                              GL_MODELVIEW_STACK_DEPTH,
                              GL_PROJECTION_STACK_DEPTH,
                              GL_ATTRIB_STACK_DEPTH,
                              GL_VERTEX_ARRAY,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_PACK_ALIGNMENT,
                              GL_CULL_FACE_MODE,
                              GL_FRONT_FACE,
                              GL_ALPHA_TEST_FUNC,
                              GL_STENCIL_FUNC,
                              GL_BLEND_SRC,
                              GL_BLEND_DST,
                              GL_LOGIC_OP_MODE})
        append(name, 1);
    append(GL_VIEWPORT, 4);
    append(GL_SCISSOR_BOX, 4);
    append(GL_COLOR_WRITEMASK, 4);
    append(GL_POLYGON_MODE, 2);
    append(GL_COLOR_CLEAR_VALUE, 4);
    append(GL_DEPTH_CLEAR_VALUE, 1);
    append(GL_DEPTH_RANGE, 2);
    append(GL_CURRENT_COLOR, 4);
    append(GL_MODELVIEW_MATRIX, 16);
    append(GL_PROJECTION_MATRIX, 16);
    row.push_back(static_cast<float>(glGetError()));
    return row;
}

/// Framebuffers, renderbuffers, textures, buffers, vertex arrays and programs that there are.
inline int living_objects()
{
    int count = 0;
    for (auto* const is_one :
         {glIsFramebuffer, glIsRenderbuffer, glIsTexture, glIsBuffer, glIsVertexArray, glIsProgram, glIsShader})
        count += living(is_one);
    return count;
}

}
