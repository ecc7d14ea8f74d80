#include <dlfcn.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <kit/scene.hpp>
#include <umbral/gl/trace.hpp>

#include "fixture.hpp"
#include "lighting/shaders/probes.hpp"
#include "lighting/shaders/scenes.hpp"
#include "pixels.hpp"

// OSMesa and EGL must be one to everybody who draws: the same pixels, the same traces, and both in one process.
namespace umbral::gl {
namespace {

/// What was drawn, as bytes, so that pictures of all formats compare bit by bit.
using Bytes = std::vector<unsigned char>;
using Gallery = std::map<std::string, Bytes>;

template <class Cell>
Bytes bytes_of(const std::vector<Cell>& cells)
{
    const auto* first = reinterpret_cast<const unsigned char*>(cells.data());
    return {first, first + cells.size() * sizeof(Cell)};
}

bool is_blank(const Bytes& bytes) { return std::equal(bytes.begin() + 4, bytes.end(), bytes.begin()); }

constexpr int size = 96;

/// A triangle lit and interpolated by fixed function, behind another one, with fog.
void draw_fixed_function()
{
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    const float place[] = {0.3F, 0.5F, 2, 1};
    const float shine[] = {0.8F, 0.7F, 0.9F, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, place);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 17);
    glBegin(GL_TRIANGLES);
    for (const float z : {0.4F, -0.3F}) {
        glNormal3f(-0.5F, -0.4F, 1);
        glVertex3f(-0.9F, -0.8F, z);
        glNormal3f(0.6F, -0.1F, 1);
        glVertex3f(0.85F, -0.7F + z, 0.1F);
        glNormal3f(0, 0.7F, 0.8F);
        glVertex3f(0.1F * z, 0.9F, -z);
    }
    glEnd();
    for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE, GL_FOG, GL_DEPTH_TEST}) glDisable(capability);
}

/// A rainbow through a shader, into colour and depth of any format, at `samples` per pixel (1: no multisampling).
Bytes draw_into(GLenum color_format, GLenum depth_format, int samples)
{
    GLuint frames[2];
    GLuint buffers[3];
    glGenFramebuffers(2, frames);
    glGenRenderbuffers(3, buffers);
    const auto attach = [&](int frame, GLuint buffer, GLenum format, GLenum point, int of_samples) {
        glBindFramebuffer(GL_FRAMEBUFFER, frames[frame]);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, of_samples > 1 ? of_samples : 0, format, size, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
    };
    attach(1, buffers[2], color_format, GL_COLOR_ATTACHMENT0, 1);
    attach(0, buffers[0], color_format, GL_COLOR_ATTACHMENT0, samples);
    attach(0, buffers[1], depth_format, GL_DEPTH_ATTACHMENT, samples);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    glViewport(0, 0, size, size);
    glClearColor(0.1F, 0.2F, 0.3F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    const Program program(vertex_source("#version 330\nin vec3 position; out vec3 place;\nvoid main() { place = "
                                        "position; gl_Position = vec4(position, 1.0); }\n"),
                          fragment_source("#version 330\nin vec3 place; out vec4 result;\nvoid main() { result = "
                                          "vec4(pow(abs(sin(7.3 * place)), vec3(1.7)), exp(-place.x)); }\n"));
    Mesh(std::array{glm::vec3(-0.9F, -0.8F, -0.7F), glm::vec3(0.95F, -0.2F, 0.6F), glm::vec3(-0.1F, 0.85F, 0.1F)}, {},
         std::array{0U, 1U, 2U})
        .draw(program);
    glDisable(GL_DEPTH_TEST);

    glBindFramebuffer(GL_READ_FRAMEBUFFER, frames[0]);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frames[1]);
    glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frames[1]);
    std::vector<float> cells(std::size_t{4} * size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_FLOAT, cells.data());
    if (samples == 1) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, frames[0]);
        cells.resize(std::size_t{5} * size * size);
        glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, &cells[std::size_t{4} * size * size]);
    }
    glDeleteFramebuffers(2, frames);
    glDeleteRenderbuffers(3, buffers);
    check_errors("drawing into a format");
    return bytes_of(cells);
}

std::string text_of(const std::string& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Image draw_projections()
{
    return draw_scene(glm::lookAt(glm::vec3(2.6F, 2.1F, 4.3F), glm::vec3(0, 0.2F, 0), glm::vec3(0, 1, 0)));
}

/// Every scene there is, drawn in the current context.
Gallery gallery()
{
    Gallery all;
    {
        const Framebuffer frame(size, size);
        frame.clear({0.2F, 0.4F, 0.6F, 1});
        draw_fixed_function();
        all["fixed function"] = bytes_of(frame.read_pixels().cells);
        all["depth"] = bytes_of(frame.read_depth().cells);
    }
    const std::pair<GLenum, GLenum> formats[] = {
        {GL_RGBA8, GL_DEPTH_COMPONENT24},     {GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT16},
        {GL_RGB10_A2, GL_DEPTH_COMPONENT32F}, {GL_RGBA16F, GL_DEPTH_COMPONENT24},
        {GL_RGBA32F, GL_DEPTH_COMPONENT32F},  {GL_R11F_G11F_B10F, GL_DEPTH_COMPONENT16}};
    for (const auto& [color, depth] : formats)
        all["format " + std::to_string(color) + ", " + std::to_string(depth)] = draw_into(color, depth, 1);
    all["multisampled"] = draw_into(GL_RGBA8, GL_DEPTH_COMPONENT24, 4);

    all["projections"] = bytes_of(draw_projections().cells);

    const std::string shaders = UMBRAL_SHADERS_REFERENCE;
    const Case what{
        "test",
        Random(1),
        {{"phong.vert", text_of(shaders + "/phong.vert")}, {"phong.frag", text_of(shaders + "/phong.frag")}}};
    const auto program = lighting::compile(what);
    const std::map<std::string, lighting::Scene> scenes = {
        {"still life", lighting::still_life()},     {"diffuse sphere", lighting::diffuse_sphere()},
        {"exponents", lighting::exponents()},       {"near lamps", lighting::near_lamps()},
        {"eight lights", lighting::eight_lights()}, {"scaled", lighting::scaled_things()},
        {"coarse", lighting::coarse_sphere(true)},  {"bowls", lighting::bowls(false)}};
    for (const auto& [name, scene] : scenes) all[name] = bytes_of(lighting::draw(scene, *program).cells);
    check_errors("drawing every scene");
    return all;
}

Gallery gallery_by(BackendKind kind)
{
    forbid_driver_threads();
    const OffscreenContext context(kind);
    return gallery();
}

void expect_same(const Gallery& one, const Gallery& other)
{
    ASSERT_EQ(one.size(), other.size());
    EXPECT_GT(one.size(), 15U);
    for (const auto& [name, bytes] : one) {
        EXPECT_TRUE(bytes == other.at(name)) << name << " differs";
        EXPECT_FALSE(is_blank(bytes)) << name << " shows nothing";
    }
}

TEST(Backends, draw_the_same_pictures_bit_by_bit)
{
    const Gallery osmesa = gallery_by(BackendKind::osmesa);
    expect_same(osmesa, gallery_by(BackendKind::egl));
    // What one leaves behind must not reach the next, in the other order either.
    const OffscreenContext context(BackendKind::osmesa);
    EXPECT_TRUE(bytes_of(draw_projections().cells) == osmesa.at("projections"));
}

TEST(Backends, live_side_by_side)
{
    forbid_driver_threads();
    OffscreenContext osmesa(BackendKind::osmesa);
    glClearColor(0.25F, 0, 0, 1);
    {
        OffscreenContext egl(BackendKind::egl);
        EXPECT_FALSE(osmesa.is_current());
        EXPECT_EQ(backend_description().substr(0, 5), "EGL: ");
        float color[4] = {9, 9, 9, 9};
        glGetFloatv(GL_COLOR_CLEAR_VALUE, color);
        EXPECT_EQ(color[0], 0);
        osmesa.make_current();  // egl goes while it is not the current one
    }
    EXPECT_TRUE(osmesa.is_current());
    EXPECT_EQ(backend_description().substr(0, 8), "OSMesa: ");
    float color[4] = {};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color);
    EXPECT_EQ(color[0], 0.25F);
    const Framebuffer frame(2, 2);
    frame.clear({1, 0, 0, 1});
    EXPECT_EQ(frame.read_pixels().at(1, 1), glm::u8vec4(255, 0, 0, 255));
}

TEST(Backends, trace_the_same_calls)
{
    std::vector<Trace> traces;
    for (const BackendKind kind : {BackendKind::osmesa, BackendKind::egl}) {
        forbid_driver_threads();
        const OffscreenContext context(kind);
        begin_trace();
        (void)draw_scene(glm::mat4(1));
        traces.push_back(end_trace());
    }
    EXPECT_GT(traces[0].calls.size(), 100U);
    EXPECT_EQ(traces[0].counts, traces[1].counts);
    EXPECT_EQ(traces[0].uploaded_bytes, traces[1].uploaded_bytes);
    ASSERT_EQ(traces[0].calls.size(), traces[1].calls.size());
    for (std::size_t i = 0; i < traces[0].calls.size(); ++i)
        EXPECT_EQ(traces[0].calls[i].name, traces[1].calls[i].name) << i;
}

TEST(Backends, keep_their_libraries_private)
{
    const OffscreenContext osmesa(BackendKind::osmesa);
    const OffscreenContext egl(BackendKind::egl);
    for (const char* name : {"OSMesaCreateContext", "eglInitialize"})
        EXPECT_EQ(dlsym(RTLD_DEFAULT, name), nullptr) << name;
    Dl_info place{};
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, "glClear"), &place), 0);
    EXPECT_NE(std::string(place.dli_fname).find("libumbral-gl"), std::string::npos) << place.dli_fname;
}

/// UMBRAL_GL set to something for one test.
class Choice : public testing::Test {
protected:
    Choice() : had_(std::getenv("UMBRAL_GL") != nullptr), old_(had_ ? std::getenv("UMBRAL_GL") : "") {}
    ~Choice() override { had_ ? setenv("UMBRAL_GL", old_.c_str(), 1) : unsetenv("UMBRAL_GL"); }

private:
    bool had_;
    std::string old_;
};

TEST_F(Choice, follows_the_environment)
{
    setenv("UMBRAL_GL", "egl", 1);
    EXPECT_EQ(default_backend(), BackendKind::egl);
    const OffscreenContext context;
    EXPECT_EQ(backend_description().substr(0, 5), "EGL: ");
    setenv("UMBRAL_GL", "osmesa", 1);
    EXPECT_EQ(default_backend(), BackendKind::osmesa);
    for (const bool empty : {true, false}) {
        empty ? setenv("UMBRAL_GL", "", 1) : unsetenv("UMBRAL_GL");
        EXPECT_EQ(default_backend(), BackendKind::osmesa);
    }
}

TEST_F(Choice, refuses_others_by_naming_both)
{
    for (const char* wrong : {"vulkan", "EGL", " egl", "osmesa,egl"}) {
        setenv("UMBRAL_GL", wrong, 1);
        try {
            (void)default_backend();
            FAIL() << wrong << " was taken";
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()),
                      "UMBRAL_GL is '" + std::string(wrong) + "': expected osmesa or egl, or unset the variable");
        }
    }
}

}
}
