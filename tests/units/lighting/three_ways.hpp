#pragma once

#include <fstream>
#include <iterator>
#include <lighting/fixed-pipeline/scenes.hpp>
#include <lighting/visible.hpp>
#include <stdexcept>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/lighting/blinn_phong.hpp>

/// The same lit scene drawn by OpenGL's fixed function, by the shaders of lighting/shaders, and in software, each by
/// its unit's reference, as light; and how far they are apart.
namespace umbral::lighting {

/// What stands where nothing is drawn: no light is negative.
inline constexpr glm::vec3 nothing(-1);

/// Does OpenGL cut colours off at 1 where it computes them, at the vertices?
enum class Clamping { none, at_vertices };

inline Grid<glm::vec3> by_fixed_function(const LitScene& scene, int size, Clamping clamping = Clamping::none)
{
    const LinearFrame frame(size, size);
    frame.clear(nothing);
    glEnable(GL_DEPTH_TEST);
    if (clamping == Clamping::at_vertices) glClampColor(GL_CLAMP_VERTEX_COLOR, GL_TRUE);
    draw_lit(scene);
    return frame.light();
}

/// The reference of lighting/shaders, compiled.
inline gl::Program reference_shaders()
{
    const auto text = [](const std::string& name) {
        std::ifstream file(std::string(UMBRAL_SOURCE_DIR "/reference/lighting/shaders/") + name);
        if (!file) throw std::runtime_error("cannot read the reference's " + name);
        return gl::ShaderSource{name, {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}};
    };
    return {text("phong.vert"), text("phong.frag")};
}

/// Their viewer is always near.
inline Grid<glm::vec3> by_shaders(const LitScene& scene, int size, const gl::Program& program)
{
    const LinearFrame frame(size, size);
    frame.clear(nothing);
    glEnable(GL_DEPTH_TEST);
    std::vector<glm::vec4> positions;
    std::vector<glm::vec3> colors;
    for (const auto& [light, its_frame] : scene.lighting.lights) {
        positions.push_back(its_frame == LightFrame::world ? scene.view * light.position : light.position);
        colors.push_back(light.color);
    }
    program.set("view", scene.view);
    program.set("projection", scene.projection);
    program.set("flat_shading", scene.lighting.flat_shading ? 1 : 0);
    program.set("light_count", static_cast<int>(positions.size()));
    program.set("light_position", positions);
    program.set("light_color", colors);
    program.set("global_ambient", scene.lighting.global_ambient);
    for (const auto& [mesh, model, material] : scene.things) {
        program.set("model", model);
        program.set("emission", material.emission);
        program.set("ambient", material.ambient);
        program.set("diffuse", material.diffuse);
        program.set("specular", material.specular);
        program.set("shininess", material.shininess);
        const LitMesh& tables = scene.meshes[mesh];
        gl::Mesh(tables.positions, tables.normals, tables.indices).draw(program);
    }
    return frame.light();
}

/// The light that each place of a thing sends to the eye, in software: light(place and unit normal in the world,
/// thing). A distant viewer stands far along the camera's axis.
inline auto software_light(const LitScene& scene)
{
    const glm::mat4 to_world = inverse(scene.view);
    const glm::vec3 eye(to_world * glm::vec4(0, 0, scene.lighting.local_viewer ? 0 : 1e6F, 1));
    std::vector<Light> lights;
    for (const auto& [light, frame] : scene.lighting.lights)
        lights.push_back({frame == LightFrame::camera ? to_world * light.position : light.position, light.color});
    return [ambient = scene.lighting.global_ambient, eye, lights](const SurfacePoint& at, const Material& material) {
        return blinn_phong_reflection(at, material, lights, ambient, eye);
    };
}

/// The front sides, the light computed at the vertices in software; OpenGL draws the triangles in these colours, and
/// computes no light.
inline Grid<glm::vec3> light_at_vertices(const LitScene& scene, int size)
{
    const LinearFrame frame(size, size);
    frame.clear(nothing);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_LIGHTING);
    glShadeModel(scene.lighting.flat_shading ? GL_FLAT : GL_SMOOTH);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(scene.projection));
    glMatrixMode(GL_MODELVIEW);
    const auto light = software_light(scene);
    for (const auto& [mesh, model, material] : scene.things) {
        const LitMesh& tables = scene.meshes[mesh];
        const glm::mat3 turned = transpose(inverse(glm::mat3(model)));
        const glm::mat4 modelview = scene.view * model;
        glLoadMatrixf(glm::value_ptr(modelview));
        glBegin(GL_TRIANGLES);
        for (const std::uint32_t i : tables.indices) {
            const glm::vec3 place(model * glm::vec4(tables.positions[i], 1));
            const glm::vec3 color = light({place, normalize(turned * tables.normals[i])}, material);
            glColor3fv(glm::value_ptr(color));
            glVertex3fv(glm::value_ptr(tables.positions[i]));
        }
        glEnd();
    }
    return frame.light();
}

/// The front sides, smooth, the light computed at every pixel.
inline Grid<glm::vec3> in_software(const LitScene& scene, int size)
{
    View view(size, size);
    for (std::size_t i = 0; i < scene.things.size(); ++i) {
        const LitMesh& tables = scene.meshes[scene.things[i].mesh];
        draw(view, scene.projection * scene.view, Shape{tables.positions, tables.normals, tables.indices},
             scene.things[i].model, static_cast<int>(i) + 1);
    }
    const auto light = software_light(scene);
    Grid<glm::vec3> result(size, size);
    std::transform(view.cells.begin(), view.cells.end(), result.cells.begin(), [&](const Visible& seen) {
        if (seen.thing == 0) return nothing;
        return light(seen.at, scene.things[static_cast<std::size_t>(seen.thing) - 1].material);
    });
    return result;
}

/// The same, cut off at 1.
inline Grid<glm::vec3> cut_off(Grid<glm::vec3> light)
{
    for (glm::vec3& one : light.cells) one = min(one, glm::vec3(1));
    return light;
}

/// How far two pictures of light are apart, as far as neither has an outline there or beside.
struct Distance {
    double largest = 0;
    double rms = 0;
    int pixels = 0;
};

inline Distance distance(const Grid<glm::vec3>& a, const Grid<glm::vec3>& b)
{
    const auto inside = [](const Grid<glm::vec3>& picture, int x, int y) {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (picture.at(x + dx, y + dy).r < 0) return false;
        return true;
    };
    Distance result;
    double squares = 0;
    for (int y = 1; y + 1 < a.height; ++y)
        for (int x = 1; x + 1 < a.width; ++x) {
            if (!inside(a, x, y) || !inside(b, x, y)) continue;
            const glm::dvec3 difference = glm::abs(glm::dvec3(a.at(x, y)) - glm::dvec3(b.at(x, y)));
            const double worst = std::max({difference.r, difference.g, difference.b});
            result.largest = std::max(result.largest, worst);
            squares += worst * worst;
            ++result.pixels;
        }
    result.rms = std::sqrt(squares / std::max(1, result.pixels));
    return result;
}

/// A ball of that many longitudes before the viewer, in one lamp and one distant light.
inline LitScene ball(int longitudes, float specular, float e)
{
    LitScene scene = seen_from({0.6F, 0.5F, 4}, {0, 0, 0}, 36);
    scene.lighting.global_ambient = glm::vec3(0.2F);
    add_light(scene, {-1.7F, 2.0F, 2.6F, 1}, {0.6F, 0.55F, 0.5F});
    add_light(scene, {0.9F, -0.2F, 0.6F, 0}, {0.15F, 0.2F, 0.3F}, LightFrame::camera);
    scene.meshes = {tables_of(sphere(longitudes, longitudes / 2))};
    scene.things = {{0, placed({0, 0, 0}, {1, 0.9F, 1}, 0.3F), shiny({0.5F, 0.4F, 0.3F}, specular, e)}};
    return scene;
}

}
