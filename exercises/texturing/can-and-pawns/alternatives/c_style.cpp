// alternative: as in C: one struct, functions that take it, vertex arrays, float throughout, letters by their
// character, and a loop that polls and draws all the time
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/texturing/lab4_program.hpp>

namespace umbral::texturing {

NormalTables normals_of(const meshes::IndexedMesh& mesh)
{
    NormalTables tables{{}, std::vector<glm::vec3>(mesh.positions.size(), glm::vec3(0))};
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 edge = mesh.positions[t[1]] - mesh.positions[t[0]];
        glm::vec3 normal = glm::cross(edge, mesh.positions[t[2]] - mesh.positions[t[0]]);
        const float size = std::sqrt(glm::dot(normal, normal));
        normal = size == 0 ? glm::vec3(0) : normal / size;
        tables.faces.push_back(normal);
        tables.vertices[t[0]] += normal;
        tables.vertices[t[1]] += normal;
        tables.vertices[t[2]] += normal;
    }
    for (glm::vec3& sum : tables.vertices) {
        const float size = glm::length(sum);
        sum = size < 1e-6F ? glm::vec3(0) : sum / size;
    }
    return tables;
}

void draw(const LitMesh& mesh, Shading shading)
{
    if (mesh.mesh.triangles.empty()) return;
    const bool textured = !mesh.coordinates.empty();
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    if (textured) glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    const auto corners = static_cast<GLsizei>(3 * mesh.mesh.triangles.size());
    if (shading == Shading::smooth) {
        glShadeModel(GL_SMOOTH);
        glVertexPointer(3, GL_FLOAT, 0, mesh.mesh.positions.data());
        glNormalPointer(GL_FLOAT, 0, mesh.normals.vertices.data());
        if (textured) glTexCoordPointer(2, GL_FLOAT, 0, mesh.coordinates.data());
        glDrawElements(GL_TRIANGLES, corners, GL_UNSIGNED_INT, mesh.mesh.triangles.data());
    } else {
        // Each corner by itself, with its face's normal.
        std::vector<glm::vec3> places;
        std::vector<glm::vec3> normals;
        std::vector<glm::vec2> coordinates;
        for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t vertex = mesh.mesh.triangles[i][k];
                places.push_back(mesh.mesh.positions[vertex]);
                normals.push_back(mesh.normals.faces[i]);
                if (textured) coordinates.push_back(mesh.coordinates[vertex]);
            }
        glShadeModel(GL_FLAT);
        glVertexPointer(3, GL_FLOAT, 0, places.data());
        glNormalPointer(GL_FLOAT, 0, normals.data());
        if (textured) glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
        glDrawArrays(GL_TRIANGLES, 0, corners);
    }
    glPopClientAttrib();
}

Revolved revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    Revolved out;
    std::vector<float> t(profile.size());
    for (std::size_t j = 1; j < profile.size(); ++j) t[j] = t[j - 1] + glm::distance(profile[j], profile[j - 1]);
    const float whole = t.back();
    const auto m = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t i = 0; i < copies; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(copies - 1);
        const glm::mat4 turn = glm::rotate(glm::mat4(1), s * 6.28318530718F, glm::vec3(0, 1, 0));
        for (std::uint32_t j = 0; j < m; ++j) {
            out.mesh.positions.emplace_back(turn * glm::vec4(profile[j], 0, 1));
            out.coordinates.emplace_back(s, t[j] / whole);
        }
    }
    for (std::uint32_t a = 0; a + m < copies * m; ++a) {
        if (a % m == m - 1) continue;
        // Triangles without area are left out.
        if (profile[a % m].x > 0) out.mesh.triangles.emplace_back(a, a + m, a + m + 1);
        if (profile[a % m + 1].x > 0) out.mesh.triangles.emplace_back(a + m + 1, a + 1, a);
    }
    return out;
}

void activate_texture(LabTexture& texture)
{
    const Picture& picture = texture.picture;
    if (texture.name == 0) {
        glGenTextures(1, &texture.name);
        glBindTexture(GL_TEXTURE_2D, texture.name);
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGB8, picture.width, picture.height);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        for (int row = 0; row < picture.height; ++row)
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, picture.height - 1 - row, picture.width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                            &picture.rgb[static_cast<std::size_t>(row * picture.width) * 3]);
    }
    glBindTexture(GL_TEXTURE_2D, texture.name);
    glEnable(GL_TEXTURE_2D);
    const auto set = [&](GLenum mode) { texture.generates ? glEnable(mode) : glDisable(mode); };
    set(GL_TEXTURE_GEN_S);
    set(GL_TEXTURE_GEN_T);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, &texture.s_plane.x);
    glTexGenfv(GL_T, GL_OBJECT_PLANE, &texture.t_plane.x);
}

static Material material(float a, float d, float s, float e, LabTexture* texture)
{
    return {{a, a, a, 1}, {d, d, d, 1}, {s, s, s, 1}, e, texture};
}

Materials make_materials(LabTexture& label, LabTexture& wood)
{
    Materials all;
    all.label = material(0.25F, 0.8F, 0.35F, 40, &label);
    all.metal = material(0.22F, 0.34F, 0.85F, 24, nullptr);
    all.wood = material(0.28F, 0.75F, 0.3F, 30, &wood);
    all.white.ambient = glm::vec4(0.26F, 0.25F, 0.24F, 1);
    all.white.diffuse = glm::vec4(0.74F, 0.72F, 0.68F, 1);
    all.black = material(0.03F, 0.04F, 0.7F, 60, nullptr);
    return all;
}

void activate_material(const Material& material)
{
    glEnable(GL_LIGHTING);
    glMaterialfv(GL_FRONT, GL_AMBIENT, &material.ambient.x);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, &material.diffuse.x);
    glMaterialfv(GL_FRONT, GL_SPECULAR, &material.specular.x);
    glMaterialf(GL_FRONT, GL_SHININESS, material.exponent);
    glDisable(GL_TEXTURE_2D);
    if (material.texture) activate_texture(*material.texture);
}

glm::vec3 direction(float alpha, float beta)
{
    const glm::mat4 turn = glm::rotate(glm::mat4(1), alpha, glm::vec3(0, 1, 0));
    return turn * glm::rotate(glm::mat4(1), -beta, glm::vec3(1, 0, 0)) * glm::vec4(0, 0, 1, 0);
}

void activate_lights(std::span<const Light> lights, const glm::mat4& view)
{
    const GLfloat nothing[4] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, nothing);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glMatrixMode(GL_MODELVIEW);
    for (unsigned i = 0; i < 8; ++i) {
        const GLenum light = GL_LIGHT0 + i;
        if (i >= lights.size()) {
            glDisable(light);
            continue;
        }
        const GLfloat color[4] = {lights[i].color.r, lights[i].color.g, lights[i].color.b, 1};
        glLightfv(light, GL_AMBIENT, color);
        glLightfv(light, GL_DIFFUSE, color);
        glLightfv(light, GL_SPECULAR, color);
        const glm::vec4 place = lights[i].directional ? glm::vec4(direction(lights[i].alpha, lights[i].beta), 0)
                                                      : glm::vec4(lights[i].position, 1);
        glPushMatrix();
        glLoadMatrixf(lights[i].directional ? glm::value_ptr(glm::mat4(1)) : glm::value_ptr(view));
        glLightfv(light, GL_POSITION, &place.x);
        glPopMatrix();
        glEnable(light);
    }
}

/// Everything that the program knows.
static struct {
    const Files* files;
    EarlierLabs* earlier;
    bool lab4, made;
    LitMesh body, top, bottom, pawn;
    LabTexture label, wood;
    Materials materials;
    Light lights[2];
} the;

static void make_mesh(LitMesh* mesh, const Bytes& file)
{
    std::vector<glm::vec2> profile;
    for (const glm::vec3& point : meshes::read_ply(file).positions) profile.emplace_back(point.x, point.y);
    const Revolved turned = revolve(profile, lab4::copies);
    *mesh = {turned.mesh, normals_of(turned.mesh), turned.coordinates};
}

static void make_scene()
{
    make_mesh(&the.body, the.files->body);
    make_mesh(&the.top, the.files->top);
    make_mesh(&the.bottom, the.files->bottom);
    make_mesh(&the.pawn, the.files->pawn);
    the.label.picture = the.files->label;
    the.wood = {the.files->wood, 0, true, lab4::wood_s_plane, lab4::wood_t_plane};
    the.materials = make_materials(the.label, the.wood);
    the.made = true;
}

static void draw_at(const glm::vec3& place, const Material& material, const LitMesh& mesh)
{
    glPushMatrix();
    glTranslatef(place.x, place.y, place.z);
    activate_material(material);
    draw(mesh, Shading::smooth);
    glPopMatrix();
}

static void draw_lab_4(int width, int height)
{
    if (!the.made) make_scene();
    glClearColor(lab4::background.x, lab4::background.y, lab4::background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    const glm::mat4 view = the.earlier->view();
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(the.earlier->projection(float(width) / float(height))));
    activate_lights(the.lights, view);
    glLoadMatrixf(glm::value_ptr(view));
    draw_at(lab4::pawns[2], the.materials.black, the.pawn);
    draw_at(lab4::pawns[1], the.materials.white, the.pawn);
    draw_at(lab4::pawns[0], the.materials.wood, the.pawn);
    draw_at({0, 0, 0}, the.materials.metal, the.bottom);
    draw_at({0, 0, 0}, the.materials.metal, the.top);
    draw_at({0, 0, 0}, the.materials.label, the.body);
    for (const GLenum mode :
         {GL_LIGHTING, GL_DEPTH_TEST, GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_LIGHT0, GL_LIGHT1})
        glDisable(mode);
}

static void on_key(GLFWwindow*, int key, int, int action, int mods)
{
    const bool letter = the.lab4 && key < 128 && std::strchr("AZXC", key) != nullptr;
    if (key == GLFW_KEY_4 && action == GLFW_PRESS) the.lab4 = !the.lab4;
    if (key != GLFW_KEY_4 && !letter) the.earlier->key(key, action, mods);
}

static void on_character(GLFWwindow*, unsigned character)
{
    if (!the.lab4) return;
    Light& light = the.lights[0];
    const float limit = glm::radians(90.0F);
    switch (character | 32U) {
        case 'a': light.beta = std::fmin(light.beta + lab4::step, limit); break;
        case 'z': light.beta = std::fmax(light.beta - lab4::step, -limit); break;
        case 'x': light.alpha += lab4::step; break;
        case 'c': light.alpha -= lab4::step; break;
        default: break;
    }
}

void run_lab4(const Files& files, EarlierLabs& earlier)
{
    the = {};
    the.files = &files;
    the.earlier = &earlier;
    the.lights[0] = {{0.85F, 0.82F, 0.76F}, true, glm::radians(-40.0F), glm::radians(35.0F), {}};
    the.lights[1] = {{0.22F, 0.27F, 0.36F}, false, 0, 0, {4, 3, -3}};
    glfwInit();
    GLFWwindow* window = glfwCreateWindow(lab4::width, lab4::height, "Práctica 4", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    while (!glfwWindowShouldClose(window)) {
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        glViewport(0, 0, width, height);
        if (the.lab4)
            draw_lab_4(width, height);
        else
            the.earlier->draw();
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    glfwTerminate();
}

}
