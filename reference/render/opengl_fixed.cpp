#include "render/opengl_fixed.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>

#include "render/opengl_objects.hpp"
#include "render/opengl_target.hpp"

namespace umbral::render {
namespace {

/// All that the fixed function keeps from one picture to the next, put back at the end.
class KeptState {
public:
    KeptState()
    {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        for (const GLenum mode : modes) {
            glMatrixMode(mode);
            glPushMatrix();
        }
    }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;
    ~KeptState()
    {
        for (const GLenum mode : modes) {
            glMatrixMode(mode);
            glPopMatrix();
        }
        glPopAttrib();
    }

private:
    static constexpr std::array<GLenum, 3> modes = {GL_TEXTURE, GL_PROJECTION, GL_MODELVIEW};
};

glm::vec4 opaque(const glm::vec3& color) { return {color, 1}; }

/// The draw list's lights are in eye coordinates, so the modelview matrix is the identity here.
void set_lights(const DrawList& list)
{
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (std::size_t i = 0; i < list.lights.size(); ++i) {
        const auto name = static_cast<GLenum>(GL_LIGHT0 + i);
        const glm::vec4 color = opaque(list.lights[i].color);
        glLightfv(name, GL_POSITION, glm::value_ptr(list.lights[i].where));
        for (const GLenum part : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glLightfv(name, part, glm::value_ptr(color));
        glEnable(name);
    }
    const glm::vec4 ambient = opaque(list.ambient);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
}

void set_once(const DrawList& list, const EffectSet& effects)
{
    set_depth_test();
    // Upside down, as the target wants it.
    const glm::mat4 projection =
        glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, -1, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, 0, 0, 1)) *
        list.projection;
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(projection));
    set_lights(list);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glDisable(GL_COLOR_MATERIAL);
    // Also what is flat: there the three corners have the facet's normal, and only light from near differs among them.
    glShadeModel(GL_SMOOTH);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    if (effects.two_sided) glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    if (effects.specular) {
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    }
    if (effects.textured) glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

/// OpenGL's light has the alpha of the material's diffuse colour: there the id comes through.
void set_material(const Draw& draw, bool specular)
{
    const auto set = [](GLenum part, const glm::vec4& color) {
        glMaterialfv(GL_FRONT_AND_BACK, part, glm::value_ptr(color));
    };
    set(GL_EMISSION, opaque(draw.material.emission));
    set(GL_AMBIENT, opaque(draw.material.ambient));
    set(GL_DIFFUSE, {draw.material.diffuse, static_cast<float>(draw.id)});
    if (!specular) return;
    set(GL_SPECULAR, opaque(draw.material.specular));
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, std::min(draw.material.exponent, fixed_function_exponent));
}

void set_texture(const Draw& draw, const DrawObjects& objects)
{
    (draw.texture ? glEnable : glDisable)(GL_TEXTURE_2D);
    (draw.texture ? glEnableClientState : glDisableClientState)(GL_TEXTURE_COORD_ARRAY);
    if (!draw.texture) return;
    objects.textures[*draw.texture]->bind();
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, uv)));
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(draw.material.texture_scale.x, draw.material.texture_scale.y, 1);
}

void draw_all(const DrawList& list, const EffectSet& effects, OpenGlWork* work)
{
    const DrawObjects objects = make_objects(list, effects.textured);
    count_once(list, objects, effects, work);
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside) continue;
        const MeshBuffers& mesh = *objects.meshes[draw.mesh];
        mesh.bind();
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_NORMAL_ARRAY);
        glVertexPointer(3, GL_FLOAT, sizeof(Vertex), nullptr);
        glNormalPointer(GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, normal)));
        if (effects.textured) set_texture(draw, objects);
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(glm::value_ptr(draw.model_view));
        set_material(draw, effects.specular);
        set_faces(draw);
        draw_counted(list, draw, effects, work, [&] { mesh.draw(); });
    }
}

}

Frame draw_with_fixed_function(const DrawList& list, const EffectSet& effects, int width, int height, OpenGlWork* work)
{
    if (list.lights.size() > fixed_function_lights)
        throw std::runtime_error("gl-fixed: expected at most 8 lights, got " + std::to_string(list.lights.size()) +
                                 ": OpenGL's fixed function has GL_LIGHT0 to GL_LIGHT7 only. Take lights out of the "
                                 "scene, or choose another --renderer");
    const OpenGlTarget target(width, height, Ids::in_alpha);
    const KeptState kept;
    glUseProgram(0);
    set_once(list, effects);
    draw_all(list, effects, work);
    gl::check_errors("drawing the scene by the fixed function");
    return target.read();
}

}
