#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <umbral/gl/interface.hpp>

namespace umbral::gl {

/// The text of a shader and the name of the file it comes from, for messages.
struct ShaderSource {
    std::string file;
    std::string text;
};

/// A linked vertex and fragment shader. Needs a current context.
class Program {
public:
    /// Compiles and links. Throws StudentError(compile_error) with the compiler's log, its lines as "phong.frag:12: …".
    Program(const ShaderSource& vertex, const ShaderSource& fragment);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program();

    /// Draws from now on use this program.
    void use() const;

    /// Attributes and uniforms that the program really uses (built-in inputs such as gl_VertexID are left out).
    [[nodiscard]] Interface interface() const;

    /// Throws StudentError(interface_mismatch) if the program has a variable that is not in `expected`, or has it with
    /// another type or a longer array; the message names each. What the program lacks is no error: see missing_names.
    void require_interface(const Interface& expected) const;

    /// Sets a uniform; the program becomes the one in use. A name that the program does not use is passed over.
    void set(const std::string& name, int value) const;
    void set(const std::string& name, float value) const;
    void set(const std::string& name, const glm::vec2& value) const;
    void set(const std::string& name, const glm::vec3& value) const;
    void set(const std::string& name, const glm::vec4& value) const;
    void set(const std::string& name, const glm::mat3& value) const;
    void set(const std::string& name, const glm::mat4& value) const;
    /// Sets the first elements of an array.
    void set(const std::string& name, std::span<const float> values) const;
    void set(const std::string& name, std::span<const glm::vec3> values) const;
    void set(const std::string& name, std::span<const glm::vec4> values) const;

    /// Where an attribute is fed; -1 if the program does not use it.
    [[nodiscard]] int attribute_location(const std::string& name) const;

private:
    /// Makes the program current; the uniform's place.
    [[nodiscard]] int place(const std::string& name) const;

    unsigned program_ = 0;
};

}
