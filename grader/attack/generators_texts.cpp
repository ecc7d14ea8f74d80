#include "attack/generators_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

std::string repeated(std::string_view text, int times)
{
    std::string result;
    result.reserve(text.size() * static_cast<std::size_t>(times));
    for (int i = 0; i < times; ++i) result += text;
    return result;
}

void append(const fs::path& file, std::string_view text)
{
    if (!(std::ofstream(file, std::ios::binary | std::ios::app) << text).flush())
        throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", file.string()));
}

fs::path shader(const fs::path& submission) { return submission / "lighting" / "shaders" / "phong.frag"; }
fs::path sphere(const fs::path& submission) { return submission / "raytracing" / "sphere" / "sphere.cpp"; }

std::string parentheses(int depth) { return repeated("(", depth) + "1" + repeated(")", depth); }

std::string numbered(std::string_view form, int count)
{
    std::string text;
    for (int i = 0; i < count; ++i) text += fmt::format(fmt::runtime(form), i);
    return text;
}

void files_of_ones(const fs::path& submission)
{
    for (int i = 0; i < 31; ++i)
        append(sphere(submission).parent_path() / fmt::format("ones{}.glsl", i),
               std::string(std::size_t{512} << 10U, '\1'));
}

struct TextGenerator {
    std::string_view name;
    void (*make)(const fs::path& submission);
};

constexpr TextGenerator text_generators[] = {
    {"shader-open-comment",
     [](const fs::path& s) { append(shader(s), "#version 330\n/* " + repeated("* never closed ", 20000)); }},
    {"shader-parentheses",
     [](const fs::path& s) { append(shader(s), "\nint deep() { return " + parentheses(40000) + "; }\n"); }},
    {"shader-uniforms", [](const fs::path& s) { append(shader(s), numbered("uniform vec4 u{0};\n", 20000)); }},
    {"shader-errors",
     [](const fs::path& s) {
         append(shader(s), "\nvoid wrong()\n{\n" + repeated("    E = E(E, E);\n", 20000) + "}\n");
     }},
    {"shader-blocks",
     [](const fs::path& s) {
         append(shader(s), "\nvoid deep() { " + repeated("{", 20000) + repeated("}", 20000) + " }\n");
     }},
    {"shader-terms",
     [](const fs::path& s) {
         append(shader(s), "\nfloat wide(float x) { return x" + repeated(" + x", 60000) + "; }\n");
     }},
    {"functions", [](const fs::path& s) { append(sphere(s), numbered("int flood_{0}() {{ return {0}; }}\n", 14000)); }},
    {"cpp-parentheses",
     [](const fs::path& s) { append(sphere(s), "\nint deep() { return " + parentheses(100000) + "; }\n"); }},
    {"cpp-errors", [](const fs::path& s) { append(sphere(s), numbered("int wrong_{0} = nobody_{0};\n", 12000)); }},
    {"files-of-ones", files_of_ones},
};

const TextGenerator* text_generator_named(std::string_view name)
{
    const auto found = std::ranges::find(text_generators, name, &TextGenerator::name);
    return found == std::end(text_generators) ? nullptr : found;
}

}

bool has_text_generator(std::string_view name) { return text_generator_named(name) != nullptr; }

void generate_text(std::string_view name, const fs::path& submission)
{
    const TextGenerator* one = text_generator_named(name);
    if (one == nullptr) throw std::runtime_error(fmt::format("there is no generator '{}'", name));
    one->make(submission);
}

}
