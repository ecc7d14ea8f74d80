#include <algorithm>
#include <umbral/gl/interface.hpp>
#include <umbral/gl/opengl.hpp>

namespace umbral::gl {
namespace {

const Variable* find(const std::vector<Variable>& variables, const std::string& name)
{
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const Variable& variable) { return variable.name == name; });
    return found == variables.end() ? nullptr : &*found;
}

void compare(const std::string& kind, const std::vector<Variable>& expected, const std::vector<Variable>& actual,
             std::vector<std::string>& sentences)
{
    for (const Variable& variable : actual) {
        const Variable* wanted = find(expected, variable.name);
        if (wanted == nullptr) {
            std::string names;
            for (const Variable& known : expected) names += (names.empty() ? "" : ", ") + known.name;
            sentences.push_back(
                "your " + kind + " '" + declaration(variable) +
                "' is not part of the interface, so nothing gives it a value; expected one of: " + names);
        } else if (wanted->type != variable.type || wanted->count < variable.count) {
            sentences.push_back("your " + kind + " is declared '" + declaration(variable) + "', expected '" +
                                declaration(*wanted) + "'");
        }
    }
}

}

std::string type_name(unsigned type)
{
    switch (type) {
        case GL_FLOAT: return "float";
        case GL_FLOAT_VEC2: return "vec2";
        case GL_FLOAT_VEC3: return "vec3";
        case GL_FLOAT_VEC4: return "vec4";
        case GL_INT: return "int";
        case GL_INT_VEC2: return "ivec2";
        case GL_INT_VEC3: return "ivec3";
        case GL_INT_VEC4: return "ivec4";
        case GL_UNSIGNED_INT: return "uint";
        case GL_BOOL: return "bool";
        case GL_BOOL_VEC2: return "bvec2";
        case GL_BOOL_VEC3: return "bvec3";
        case GL_BOOL_VEC4: return "bvec4";
        case GL_FLOAT_MAT2: return "mat2";
        case GL_FLOAT_MAT3: return "mat3";
        case GL_FLOAT_MAT4: return "mat4";
        case GL_DOUBLE: return "double";
        case GL_SAMPLER_1D: return "sampler1D";
        case GL_SAMPLER_2D: return "sampler2D";
        case GL_SAMPLER_3D: return "sampler3D";
        case GL_SAMPLER_CUBE: return "samplerCube";
        case GL_SAMPLER_2D_SHADOW: return "sampler2DShadow";
        default: return "type " + std::to_string(type);
    }
}

std::string declaration(const Variable& variable)
{
    std::string text = type_name(variable.type) + ' ' + variable.name;
    if (variable.count > 1) text.append("[").append(std::to_string(variable.count)).append("]");
    return text;
}

std::vector<std::string> mismatches(const Interface& expected, const Interface& actual)
{
    std::vector<std::string> sentences;
    compare("attribute", expected.attributes, actual.attributes, sentences);
    compare("uniform", expected.uniforms, actual.uniforms, sentences);
    return sentences;
}

std::vector<std::string> missing_names(const Interface& expected, const Interface& actual)
{
    std::vector<std::string> names;
    for (const Variable& variable : expected.attributes)
        if (find(actual.attributes, variable.name) == nullptr) names.push_back(variable.name);
    for (const Variable& variable : expected.uniforms)
        if (find(actual.uniforms, variable.name) == nullptr) names.push_back(variable.name);
    return names;
}

}
