// alternative: a shader and a framebuffer of whole numbers; the position from matrices multiplied here; buffers that
// are filled anew for each thing
#include <umbral/gl/opengl.hpp>
#include <umbral/interaction/pick_ids.hpp>

namespace umbral::interaction {
namespace {

const char* const vertex_text = R"(#version 330 core
layout(location = 0) in vec3 place;
uniform mat4 all;
void main() { gl_Position = all * vec4(place, 1.0); }
)";
const char* const fragment_text = R"(#version 330 core
uniform uint id;
layout(location = 0) out uint result;
void main() { result = id; }
)";

GLuint shader_of(GLenum kind, const char* text)
{
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

int value_of(GLenum name)
{
    int value = 0;
    glGetIntegerv(name, &value);
    return value;
}

const GLenum switches[] = {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_CULL_FACE,
                           GL_ALPHA_TEST,   GL_DITHER,       GL_FOG,   GL_DEPTH_TEST};

class ShaderPicker final : public IdPicker {
public:
    ~ShaderPicker() override
    {
        if (program_ == 0) return;
        glDeleteProgram(program_);
        glDeleteBuffers(2, buffers_);
        glDeleteVertexArrays(1, &vertex_array_);
        release_pictures();
    }

    Grid<std::uint32_t> ids_around(const PickScene& scene, const glm::ivec2& picture, const glm::ivec2& pixel,
                                   int radius) override
    {
        const int draw = value_of(GL_DRAW_FRAMEBUFFER_BINDING);
        const int read = value_of(GL_READ_FRAMEBUFFER_BINDING);
        const int program = value_of(GL_CURRENT_PROGRAM);
        const int texture = value_of(GL_TEXTURE_BINDING_2D);
        const int function = value_of(GL_DEPTH_FUNC);
        int mode[2];
        glGetIntegerv(GL_POLYGON_MODE, mode);
        int viewport[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        double range[2];
        glGetDoublev(GL_DEPTH_RANGE, range);
        GLboolean mask[4];
        glGetBooleanv(GL_COLOR_WRITEMASK, mask);
        GLboolean depth_mask = GL_TRUE;
        glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask);
        GLboolean was_on[9];
        for (int i = 0; i < 9; ++i) was_on[i] = glIsEnabled(switches[i]);

        for (const GLenum name : switches) glDisable(name);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glDepthMask(GL_TRUE);
        glDepthRange(0, 1);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        prepare(picture);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glViewport(0, 0, picture.x, picture.y);
        const GLuint nothing[4] = {0, 0, 0, 0};
        const float far_away = 1;
        glClearBufferuiv(GL_COLOR, 0, nothing);
        glClearBufferfv(GL_DEPTH, 0, &far_away);
        draw_all(scene);
        Grid<std::uint32_t> result = read_block(picture, pixel, radius);

        for (int i = 0; i < 9; ++i) was_on[i] == GL_TRUE ? glEnable(switches[i]) : glDisable(switches[i]);
        glDepthFunc(static_cast<GLenum>(function));
        glDepthMask(depth_mask);
        glDepthRange(range[0], range[1]);
        glColorMask(mask[0], mask[1], mask[2], mask[3]);
        glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(mode[0]));
        glUseProgram(static_cast<GLuint>(program));
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        return result;
    }

private:
    void release_pictures()
    {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(2, pictures_);
    }

    void prepare(const glm::ivec2& picture)
    {
        if (program_ == 0) {
            program_ = glCreateProgram();
            const GLuint vertex = shader_of(GL_VERTEX_SHADER, vertex_text);
            const GLuint fragment = shader_of(GL_FRAGMENT_SHADER, fragment_text);
            glAttachShader(program_, vertex);
            glAttachShader(program_, fragment);
            glLinkProgram(program_);
            glDeleteShader(vertex);
            glDeleteShader(fragment);
            glGenVertexArrays(1, &vertex_array_);
            glGenBuffers(2, buffers_);
        }
        if (picture == made_for_) return;
        if (made_for_.x > 0) release_pictures();
        made_for_ = picture;
        glGenTextures(2, pictures_);
        glBindTexture(GL_TEXTURE_2D, pictures_[0]);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32UI, picture.x, picture.y);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindTexture(GL_TEXTURE_2D, pictures_[1]);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, picture.x, picture.y);
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, pictures_[0], 0);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, pictures_[1], 0);
    }

    void draw_all(const PickScene& scene) const
    {
        glUseProgram(program_);
        glBindVertexArray(vertex_array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        for (const PickThing& thing : scene.things) {
            const PickMesh& mesh = scene.meshes[thing.mesh];
            if (thing.id == 0 || mesh.indices.empty()) continue;
            const glm::mat4 all = scene.projection * scene.view * thing.model;
            glUniformMatrix4fv(glGetUniformLocation(program_, "all"), 1, GL_FALSE, &all[0][0]);
            glUniform1ui(glGetUniformLocation(program_, "id"), thing.id);
            glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.positions.size() * sizeof(glm::vec3)),
                         mesh.positions.data(), GL_STREAM_DRAW);
            glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * 4), mesh.indices.data(),
                         GL_STREAM_DRAW);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
        }
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    static Grid<std::uint32_t> read_block(const glm::ivec2& picture, const glm::ivec2& pixel, int radius)
    {
        std::vector<std::uint32_t> all(static_cast<std::size_t>(picture.x) * static_cast<std::size_t>(picture.y));
        glReadPixels(0, 0, picture.x, picture.y, GL_RED_INTEGER, GL_UNSIGNED_INT, all.data());
        const int side = 2 * radius + 1;
        Grid<std::uint32_t> ids(side, side);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const int x = pixel.x - radius + column;
                const int y = picture.y - 1 - (pixel.y - radius + row);
                if (x < 0 || y < 0 || x >= picture.x || y >= picture.y) continue;
                ids.at(column, row) = all[static_cast<std::size_t>(y * picture.x + x)];
            }
        return ids;
    }

    glm::ivec2 made_for_{0};
    GLuint program_ = 0;
    GLuint vertex_array_ = 0;
    GLuint buffers_[2] = {0, 0};
    GLuint framebuffer_ = 0;
    GLuint pictures_[2] = {0, 0};
};

}

glm::u8vec3 color_of_id(std::uint32_t id)
{
    if (id > 0xFFFFFF) throw std::invalid_argument("color_of_id: the id has no room in three bytes");
    return {id % 256, id / 256 % 256, id / 65536};
}

std::uint32_t id_of_color(const glm::u8vec3& color) { return color[0] + 256U * color[1] + 65536U * color[2]; }

std::unique_ptr<IdPicker> make_id_picker() { return std::make_unique<ShaderPicker>(); }

std::uint32_t nearest_id(const Grid<std::uint32_t>& ids)
{
    std::vector<glm::ivec2> places;
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            if (ids.at(x, y) != 0) places.emplace_back(x, y);
    if (places.empty()) return 0;
    const float middle = 0.5F * static_cast<float>(ids.width - 1);
    const auto away = [&](const glm::ivec2& place) { return glm::distance(glm::vec2(place), glm::vec2(middle)); };
    const auto nearest = std::min_element(places.begin(), places.end(),
                                          [&](const glm::ivec2& a, const glm::ivec2& b) { return away(a) < away(b); });
    return ids.at(nearest->x, nearest->y);
}

}
