// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 2.1). 2006, section 2.14.

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/lighting/fixed_pipeline.hpp>

namespace umbral::lighting {
namespace {

/// As many as every OpenGL has.
constexpr std::size_t maximum_lights = 8;
constexpr float maximum_shininess = 128;

GLenum name_of_light(std::size_t i) { return static_cast<GLenum>(GL_LIGHT0 + i); }

/// OpenGL reads four numbers of each colour.
glm::vec4 opaque(const glm::vec3& color) { return {color, 1}; }

/// OpenGL multiplies the position by the modelview matrix of this moment, and keeps it in eye coordinates.
void set_light(GLenum name, const PlacedLight& placed, const glm::mat4& view)
{
    const glm::mat4 to_eye = placed.frame == LightFrame::world ? view : glm::mat4(1);
    glLoadMatrixf(glm::value_ptr(to_eye));
    glLightfv(name, GL_POSITION, glm::value_ptr(placed.light.position));

    const glm::vec4 color = opaque(placed.light.color);
    for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glLightfv(name, part, glm::value_ptr(color));

    glLightf(name, GL_SPOT_CUTOFF, 180);
    glLightf(name, GL_CONSTANT_ATTENUATION, 1);
    glLightf(name, GL_LINEAR_ATTENUATION, 0);
    glLightf(name, GL_QUADRATIC_ATTENUATION, 0);
    glEnable(name);
}

void set_light_model(const FrameLighting& lighting)
{
    const glm::vec4 ambient = opaque(lighting.global_ambient);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer ? GL_TRUE : GL_FALSE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glShadeModel(lighting.flat_shading ? GL_FLAT : GL_SMOOTH);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    // Where it is on, materials follow the current colour, and glMaterial does nothing.
    glDisable(GL_COLOR_MATERIAL);
}

void draw(const LitMesh& mesh)
{
    glVertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
    glNormalPointer(GL_FLOAT, 0, mesh.normals.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
}

}

void set_lighting(const FrameLighting& lighting, const glm::mat4& view)
{
    // Not glPushAttrib(GL_TRANSFORM_BIT): that would put back GL_NORMALIZE, too.
    GLint mode = 0;
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    const std::size_t count = std::min(lighting.lights.size(), maximum_lights);
    for (std::size_t i = 0; i < count; ++i) set_light(name_of_light(i), lighting.lights[i], view);
    glPopMatrix();
    glMatrixMode(static_cast<GLenum>(mode));

    for (std::size_t i = count; i < maximum_lights; ++i) glDisable(name_of_light(i));
    set_light_model(lighting);
}

void set_material(const Material& material)
{
    const auto set = [](GLenum part, const glm::vec3& color) {
        const glm::vec4 with_alpha = opaque(color);
        glMaterialfv(GL_FRONT_AND_BACK, part, glm::value_ptr(with_alpha));
    };
    set(GL_EMISSION, material.emission);
    set(GL_AMBIENT, material.ambient);
    set(GL_DIFFUSE, material.diffuse);
    set(GL_SPECULAR, material.specular);
    // Beyond the maximum OpenGL notes an error, and keeps the exponent of the material before.
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, std::min(material.shininess, maximum_shininess));
}

void draw_lit(const LitScene& scene)
{
    // All that is set below; the materials are among the lighting.
    glPushAttrib(GL_LIGHTING_BIT | GL_TRANSFORM_BIT | GL_POLYGON_BIT);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadMatrixf(glm::value_ptr(scene.projection));
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);

    set_lighting(scene.lighting, scene.view);
    for (const LitThing& thing : scene.things) {
        const glm::mat4 modelview = scene.view * thing.model;
        glLoadMatrixf(glm::value_ptr(modelview));
        // A mirror turns clockwise what was anticlockwise.
        glFrontFace(glm::determinant(glm::mat3(thing.model)) < 0 ? GL_CW : GL_CCW);
        set_material(thing.material);
        draw(scene.meshes[thing.mesh]);
    }

    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glPopClientAttrib();
    glPopAttrib();
}

}
