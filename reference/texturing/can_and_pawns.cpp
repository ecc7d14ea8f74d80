// Based on: the course's lab 4, "Materiales, fuentes de luz y texturas". M. Segal, K. Akeley. The OpenGL Graphics
// System: A Specification (Version 4.5, Compatibility Profile). 2017.

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <memory>
#include <umbral/gl/opengl.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/texturing/lab4_program.hpp>

namespace umbral::texturing {
namespace {

/// Makes the texture that is bound of a picture. OpenGL's first row is the one at t = 0, a picture's the one at its
/// top.
void upload(const Picture& picture)
{
    std::vector<std::uint8_t> rows;
    const auto size = static_cast<std::ptrdiff_t>(picture.width) * 3;
    for (auto end = picture.rgb.end(); end != picture.rgb.begin(); end -= size)
        rows.insert(rows.end(), end - size, end);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);  // rows of an odd width are not filled up to four bytes
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

void generate(GLenum coordinate, GLenum mode, const glm::vec4& plane)
{
    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(coordinate, GL_OBJECT_PLANE, value_ptr(plane));
    glEnable(mode);
}

/// What the program shows in lab 4's mode. Textures have addresses that materials know: it is not moved.
class Scene {
public:
    explicit Scene(const Files& files)
        : body_(revolved(files.body)),
          top_(revolved(files.top)),
          bottom_(revolved(files.bottom)),
          pawn_(revolved(files.pawn)),
          label_{.picture = files.label},
          wood_{.picture = files.wood, .generates = true, .s_plane = lab4::wood_s_plane, .t_plane = lab4::wood_t_plane},
          materials_(make_materials(label_, wood_))
    {
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void draw(const glm::mat4& view) const
    {
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(view));
        show(materials_.label, body_);
        show(materials_.metal, top_);
        show(materials_.metal, bottom_);
        std::size_t i = 0;
        for (const Material* material : {&materials_.wood, &materials_.white, &materials_.black}) {
            glLoadMatrixf(value_ptr(translate(view, lab4::pawns[i++])));
            show(*material, pawn_);
        }
    }

private:
    static LitMesh revolved(const Bytes& file)
    {
        const std::vector<glm::vec3> points = meshes::read_ply(file).positions;
        const std::vector<glm::vec2> profile(points.begin(), points.end());
        Revolved surface = revolve(profile, lab4::copies);
        NormalTables normals = normals_of(surface.mesh);
        return {std::move(surface.mesh), std::move(normals), std::move(surface.coordinates)};
    }

    static void show(const Material& material, const LitMesh& mesh)
    {
        activate_material(material);
        texturing::draw(mesh, Shading::smooth);
    }

    LitMesh body_, top_, bottom_, pawn_;
    LabTexture label_, wood_;
    Materials materials_;
};

/// The program behind the window's user pointer.
struct Program {
    const Files& files;
    EarlierLabs& earlier;
    bool in_lab_4 = false;
    bool changed = true;  ///< since the last frame
    std::array<Light, 2> lights{};
    std::unique_ptr<Scene> scene{};
};

Program& program_of(GLFWwindow* window) { return *static_cast<Program*>(glfwGetWindowUserPointer(window)); }

void draw_lab_4(Program& program, float aspect)
{
    if (!program.scene) program.scene = std::make_unique<Scene>(program.files);
    glClearColor(lab4::background.r, lab4::background.g, lab4::background.b, lab4::background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // What is enabled here is not for the earlier labs.
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(value_ptr(program.earlier.projection(aspect)));
    activate_lights(program.lights, program.earlier.view());
    program.scene->draw(program.earlier.view());
    glPopAttrib();
}

void draw_frame(GLFWwindow* window)
{
    Program& program = program_of(window);
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    glViewport(0, 0, width, height);
    if (program.in_lab_4)
        draw_lab_4(program, static_cast<float>(width) / static_cast<float>(std::max(height, 1)));
    else
        program.earlier.draw();
    glfwSwapBuffers(window);
    program.changed = false;
}

/// How a key turns the light, in steps of α and β; zero for all other keys.
glm::vec2 turn_of(int key)
{
    const auto if_it_is = [&](int named) { return key == named ? 1.0F : 0.0F; };
    return {if_it_is(GLFW_KEY_X) - if_it_is(GLFW_KEY_C), if_it_is(GLFW_KEY_A) - if_it_is(GLFW_KEY_Z)};
}

void on_key(GLFWwindow* window, int key, int, int action, int mods)
{
    constexpr float highest = std::numbers::pi_v<float> / 2;
    Program& program = program_of(window);
    program.changed = true;
    const glm::vec2 turn = program.in_lab_4 ? turn_of(key) : glm::vec2(0);
    if (key == GLFW_KEY_4) {
        if (action == GLFW_PRESS) program.in_lab_4 = !program.in_lab_4;
    } else if (turn == glm::vec2(0)) {
        program.earlier.key(key, action, mods);
    } else if (action != GLFW_RELEASE) {
        Light& light = program.lights[0];
        light.alpha += lab4::step * turn.x;
        light.beta = std::clamp(light.beta + lab4::step * turn.y, -highest, highest);
    }
}

}

NormalTables normals_of(const meshes::IndexedMesh& mesh)
{
    NormalTables tables;
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& t : mesh.triangles) {
        // In double, differences of floats lose nothing, and products of them neither overflow nor underflow.
        const glm::dvec3 p(mesh.positions[t.x]);
        const glm::dvec3 m = cross(glm::dvec3(mesh.positions[t.y]) - p, glm::dvec3(mesh.positions[t.z]) - p);
        const glm::dvec3 normal = length(m) > 0 ? normalize(m) : glm::dvec3(0);
        tables.faces.emplace_back(normal);
        for (int corner = 0; corner < 3; ++corner) sums[t[corner]] += normal;
    }
    for (const glm::dvec3& sum : sums)
        tables.vertices.emplace_back(length(sum) < 1e-6 ? glm::dvec3(0) : normalize(sum));
    return tables;
}

void draw(const LitMesh& mesh, Shading shading)
{
    const bool flat = shading == Shading::flat;
    glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
    glBegin(GL_TRIANGLES);
    for (std::size_t face = 0; face < mesh.mesh.triangles.size(); ++face) {
        if (flat) glNormal3fv(value_ptr(mesh.normals.faces[face]));
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.mesh.triangles[face][corner];
            if (!flat) glNormal3fv(value_ptr(mesh.normals.vertices[vertex]));
            if (!mesh.coordinates.empty()) glTexCoord2fv(value_ptr(mesh.coordinates[vertex]));
            glVertex3fv(value_ptr(mesh.mesh.positions[vertex]));
        }
    }
    glEnd();
}

Revolved revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    const auto count = static_cast<std::uint32_t>(profile.size());
    std::vector<double> lengths{0};
    for (std::uint32_t j = 1; j < count; ++j)
        lengths.push_back(lengths.back() + distance(glm::dvec2(profile[j]), glm::dvec2(profile[j - 1])));
    Revolved result;
    for (std::uint32_t i = 0; i < copies; ++i) {
        const double s = static_cast<double>(i) / (copies - 1);
        const double angle = 2 * std::numbers::pi * (i + 1 == copies ? 0 : s);
        for (std::uint32_t j = 0; j < count; ++j) {
            const double x = profile[j].x;
            result.mesh.positions.emplace_back(x * std::cos(angle), profile[j].y, -x * std::sin(angle));
            result.coordinates.emplace_back(s, lengths[j] / lengths.back());
            if (i + 1 == copies || j + 1 == count) continue;
            const std::uint32_t a = i * count + j;
            const std::uint32_t b = a + count;
            result.mesh.triangles.insert(result.mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
        }
    }
    return result;
}

void activate_texture(LabTexture& texture)
{
    glEnable(GL_TEXTURE_2D);
    const bool first_time = texture.name == 0;
    if (first_time) glGenTextures(1, &texture.name);
    glBindTexture(GL_TEXTURE_2D, texture.name);
    if (first_time) upload(texture.picture);
    if (texture.generates) {
        generate(GL_S, GL_TEXTURE_GEN_S, texture.s_plane);
        generate(GL_T, GL_TEXTURE_GEN_T, texture.t_plane);
    } else {
        glDisable(GL_TEXTURE_GEN_S);
        glDisable(GL_TEXTURE_GEN_T);
    }
}

Materials make_materials(LabTexture& label, LabTexture& wood)
{
    const auto grey = [](float value) { return glm::vec4(glm::vec3(value), 1); };
    return {.label = {grey(0.25F), grey(0.80F), grey(0.35F), 40, &label},
            .metal = {grey(0.22F), grey(0.34F), grey(0.85F), 24, nullptr},
            .wood = {grey(0.28F), grey(0.75F), grey(0.30F), 30, &wood},
            .white = {{0.26F, 0.25F, 0.24F, 1}, {0.74F, 0.72F, 0.68F, 1}, grey(0), 0, nullptr},
            .black = {grey(0.03F), grey(0.04F), grey(0.70F), 60, nullptr}};
}

void activate_material(const Material& material)
{
    glEnable(GL_LIGHTING);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, value_ptr(material.ambient));
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, value_ptr(material.diffuse));
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, value_ptr(material.specular));
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.exponent);
    if (material.texture != nullptr)
        activate_texture(*material.texture);
    else
        glDisable(GL_TEXTURE_2D);
}

glm::vec3 direction(float alpha, float beta)
{
    return {std::cos(beta) * std::sin(alpha), std::sin(beta), std::cos(beta) * std::cos(alpha)};
}

void activate_lights(std::span<const Light> lights, const glm::mat4& view)
{
    constexpr glm::vec4 no_light{0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, value_ptr(no_light));
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();  // glLight takes places by the modelview matrix of the moment
    for (GLenum i = 0; i < 8; ++i) glDisable(GL_LIGHT0 + i);
    GLenum name = GL_LIGHT0;
    for (const Light& light : lights) {
        const glm::vec4 color(light.color, 1);
        const glm::vec4 place =
            light.directional ? glm::vec4(direction(light.alpha, light.beta), 0) : view * glm::vec4(light.position, 1);
        for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glLightfv(name, part, value_ptr(color));
        glLightfv(name, GL_POSITION, value_ptr(place));
        glEnable(name++);
    }
    glPopMatrix();
}

void run_lab4(const Files& files, EarlierLabs& earlier)
{
    glfwInit();
    GLFWwindow* window = glfwCreateWindow(lab4::width, lab4::height, "Lab 4", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    Program program{.files = files, .earlier = earlier};
    program.lights[0] = {.color = {0.85F, 0.82F, 0.76F}, .alpha = glm::radians(-40.0F), .beta = glm::radians(35.0F)};
    program.lights[1] = {.color = {0.22F, 0.27F, 0.36F}, .directional = false, .position = {4, 3, -3}};
    glfwSetWindowUserPointer(window, &program);
    glfwSetKeyCallback(window, on_key);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { program_of(w).changed = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { program_of(w).changed = true; });
    while (glfwWindowShouldClose(window) == GLFW_FALSE) {
        if (program.changed) draw_frame(window);
        glfwWaitEvents();
    }
    glfwDestroyWindow(window);
    glfwTerminate();
}

}
