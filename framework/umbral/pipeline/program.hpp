#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <umbral/core/not_implemented.hpp>

namespace umbral::pipeline {

/// The texts of a vertex and a fragment shader, in GLSL.
struct ShaderTexts {
    std::string vertex;
    std::string fragment;
};

/// Why a program could not be made: the first step that failed, and what OpenGL says of it.
class ShaderError : public std::runtime_error {
public:
    enum class Step { compile_vertex = 1, compile_fragment = 2, link = 3 };

    /// `log` is the info log of that step: all of it, however long, and nothing else. what() returns it.
    ShaderError(Step step, const std::string& log) : std::runtime_error(log), step_(step) {}
    [[nodiscard]] Step step() const noexcept { return step_; }

private:
    Step step_;
};

/// A program object (objeto programa) that was compiled and linked, and its uniforms. The destructor deletes it.
///
/// Needs a current OpenGL 4.1 context all its life.
class ShaderProgram {
public:
    virtual ~ShaderProgram() = default;

    /// What is drawn from now on is drawn by this program.
    virtual void use() = 0;

    /// Sets a uniform of *this* program, whichever program is in use; that one stays in use. Matrices have GLM's order,
    /// column by column. A name may be an element's or a member's: vectors[1], lamp.color.
    ///
    /// Returns false, and does nothing, if the program has no such uniform or does not use it. The type must be the
    /// uniform's.
    virtual bool set(const std::string& name, int value) = 0;  ///< int, bool, or a sampler's texture unit
    virtual bool set(const std::string& name, float value) = 0;
    virtual bool set(const std::string& name, const glm::vec3& value) = 0;
    virtual bool set(const std::string& name, const glm::vec4& value) = 0;
    virtual bool set(const std::string& name, const glm::mat3& value) = 0;
    virtual bool set(const std::string& name, const glm::mat4& value) = 0;
};

/// Compiles the vertex shader, then the fragment shader, links them, and deletes the shaders: a program does not need
/// them any more.
///
/// Throws ShaderError at the first step that fails; then no object of OpenGL is left. The program in use stays in use.
/// Course: CompilarShader, VerErroresCompilar, VerErroresEnlazar, CauceProgramable::CauceProgramable.
[[nodiscard]] std::unique_ptr<ShaderProgram> make_shader_program(const ShaderTexts& texts);

/// The least that draws. Attributes: vec3 position, vec3 color. Uniforms: mat4 modelview, mat4 projection.
///
/// Colours are interpolated between vertices; alpha is 1. Course: the minimal shaders (fuente_vs, fuente_fs).
[[nodiscard]] ShaderTexts minimal_shaders();

/// With switches for light and texture.
///
/// - Attributes: vec3 position, vec3 normal (unit), vec3 color, vec2 tex_coord.
/// - Uniforms: mat4 modelview; mat4 projection; mat3 normal_matrix, for normals, object to eye; vec3 light, a unit
/// vector towards the light in eye
///   coordinates; sampler2D image; int lighting, flat_shading, textured, each 0 or 1.
/// - The colour c is the image's at tex_coord if textured is 1, else the interpolated color. If lighting is 1 it is c
/// (0.25 + 0.75 max(0, n·light)). Alpha is 1.
/// - The unit vector n is the interpolated normal, normalised again; or, if flat_shading is 1, the triangle's own
/// normal that points to the viewer.
///
/// Course: the larger shaders, with eval_mil, sombr_plano and eval_text.
[[nodiscard]] ShaderTexts lit_shaders();

}
