// alternative: vertex by vertex, all attributes kept, no helper of OpenGL's matrices but loading
#include <umbral/gl/opengl.hpp>
#include <umbral/lighting/fixed_pipeline.hpp>

namespace umbral::lighting {
namespace {

void set_color(GLenum light, GLenum part, const glm::vec3& color)
{
    const GLfloat numbers[] = {color.r, color.g, color.b, 1};
    glLightfv(light, part, numbers);
}

void set_color_of_both(GLenum part, const glm::vec3& color)
{
    const GLfloat numbers[] = {color.r, color.g, color.b, 1};
    glMaterialfv(GL_FRONT, part, numbers);
    glMaterialfv(GL_BACK, part, numbers);
}

}

void set_lighting(const FrameLighting& lighting, const glm::mat4& view)
{
    glPushAttrib(GL_TRANSFORM_BIT);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    for (GLenum i = 0; i < 8; ++i) {
        const GLenum light = GL_LIGHT0 + i;
        glDisable(light);
        if (i >= lighting.lights.size()) continue;
        const PlacedLight& placed = lighting.lights[i];
        glLoadIdentity();
        if (placed.frame == LightFrame::world) glMultMatrixf(&view[0][0]);
        glLightfv(light, GL_POSITION, &placed.light.position[0]);
        set_color(light, GL_AMBIENT, placed.light.color);
        set_color(light, GL_DIFFUSE, placed.light.color);
        set_color(light, GL_SPECULAR, placed.light.color);
        glLighti(light, GL_SPOT_CUTOFF, 180);
        glLighti(light, GL_SPOT_EXPONENT, 0);
        const GLfloat weakening[] = {1, 0, 0};
        for (GLenum k = 0; k < 3; ++k) glLightf(light, GL_CONSTANT_ATTENUATION + k, weakening[k]);
        glEnable(light);
    }
    glPopMatrix();
    glPopAttrib();
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glDisable(GL_RESCALE_NORMAL);
    glDisable(GL_COLOR_MATERIAL);
    const GLfloat ambient[] = {lighting.global_ambient.r, lighting.global_ambient.g, lighting.global_ambient.b, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, static_cast<GLint>(lighting.local_viewer));
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glShadeModel(lighting.flat_shading ? GL_FLAT : GL_SMOOTH);
}

void set_material(const Material& material)
{
    set_color_of_both(GL_EMISSION, material.emission);
    set_color_of_both(GL_AMBIENT, material.ambient);
    set_color_of_both(GL_DIFFUSE, material.diffuse);
    set_color_of_both(GL_SPECULAR, material.specular);
    const GLfloat exponent = material.shininess > 128 ? 128 : material.shininess;
    glMaterialf(GL_FRONT, GL_SHININESS, exponent);
    glMaterialf(GL_BACK, GL_SHININESS, exponent);
}

void draw_lit(const LitScene& scene)
{
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    for (const GLenum stack : {GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(stack);
        glPushMatrix();
        glLoadMatrixf(stack == GL_PROJECTION ? &scene.projection[0][0] : &scene.view[0][0]);
    }
    set_lighting(scene.lighting, scene.view);
    for (const LitThing& thing : scene.things) {
        const LitMesh& mesh = scene.meshes[thing.mesh];
        set_material(thing.material);
        const glm::mat3 a(thing.model);
        glFrontFace(dot(cross(a[0], a[1]), a[2]) < 0 ? GL_CW : GL_CCW);
        glPushMatrix();
        glMultMatrixf(&thing.model[0][0]);
        glBegin(GL_TRIANGLES);
        for (const std::uint32_t i : mesh.indices) {
            glNormal3fv(&mesh.normals[i][0]);
            glVertex3fv(&mesh.positions[i][0]);
        }
        glEnd();
        glPopMatrix();
    }
    for (const GLenum stack : {GL_PROJECTION, GL_MODELVIEW}) {
        glMatrixMode(stack);
        glPopMatrix();
    }
    glPopAttrib();
}

}
