#include <fmt/format.h>

#include <cstdlib>

#include "inputs.hpp"

namespace stability {
namespace {

std::string literal(float value)
{
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text + "F";
}

std::string literals(Numbers x)
{
    std::string text;
    for (const float value : x) text += (text.empty() ? "" : ", ") + literal(value);
    return text;
}

}

std::string code_of(const Call& call, Numbers x)
{
    std::string code = std::string(call.name).substr(0, std::string(call.name).find(' ')) + "(";
    std::size_t at = 0;
    const auto take = [&](const char* open, std::size_t count, const char* close) {
        if (code.back() != '(' && code.back() != '{' && code.back() != ',') code += ", ";
        code += open + literals(x.subspan(at, count)) + close;
        at += count;
    };
    for (const char letter : std::string_view(call.shape)) {
        switch (letter) {
            case 'f': take("", 1, ""); break;
            case 'u': take("glm::vec2(", 2, ")"); break;
            case 'v': take("glm::vec3(", 3, ")"); break;
            case 'w': take("glm::vec4(", 4, ")"); break;
            case 'm': take("glm::mat3(", 9, ")"); break;
            case 'M': take("glm::mat4(", 16, ")"); break;
            case '{':
                if (code.back() != '(' && code.back() != '{' && code.back() != ',') code += ", ";
                code += letter;
                break;
            default: code += letter;
        }
    }
    return code + ")";
}

}
