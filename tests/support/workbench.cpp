#include "support/workbench.hpp"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "build/student_header.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> words(const std::string& text)
{
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) result.push_back(word);
    return result;
}

}

Workbench::Workbench()
{
    const fs::path source = UMBRAL_SOURCE_DIR;
    const fs::path build = UMBRAL_BUILD_DIR;
    tools_ = {.exercises = source / "exercises",
              .reference = source / "reference",
              .units = build / "units",
              .programs = build / "bin",
              .framework = source / "framework",
              .student_header = build / "student" / "umbral_student.hpp",
              .cache = folder() / "cache",
              .compiler = UMBRAL_COMPILER,
              .flags = words(UMBRAL_TEST_STUDENT_FLAGS)};
}

Toolchain Workbench::fixture_tools() const
{
    Toolchain tools = tools_;
    tools.exercises = std::string(UMBRAL_SOURCE_DIR) + "/tests/fixtures/exercises";
    tools.reference = std::string(UMBRAL_SOURCE_DIR) + "/tests/fixtures/reference";
    return tools;
}

RunRequest Workbench::sphere_run(const fs::path& library, const std::string& case_name) const
{
    return {unit_folder(tools_, "raytracing/sphere") / "driver.so",
            library,
            {},
            case_name,
            1,
            {.wall_seconds = 5, .memory_mib = 512}};
}

fs::path Workbench::compile_sphere(const std::string& text) const
{
    static std::atomic<int> number = 0;
    const std::string name = "raw-" + std::to_string(++number);
    const fs::path source = write(name + ".cpp", text);
    fs::path library = folder() / (name + ".so");
    std::string command = tools_.compiler;
    for (const std::string& flag : tools_.flags) command += " " + flag;
    for (const std::string& word : read_first(tools_, exercise("raytracing/sphere"))) command += " " + word;
    command += " -w -shared -fuse-ld=mold -Wl,-z,lazy -Wl,--version-script=" +
               (unit_folder(tools_, "raytracing/sphere") / "exports.map").string() + " -o " + library.string() + " " +
               source.string();
    if (std::system(command.c_str()) != 0) throw std::runtime_error("does not compile: " + text);
    return library;
}

fs::path Workbench::write(const fs::path& name, const std::string& text) const
{
    const fs::path path = folder_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

std::string project_file(const std::string& path) { return read_text(fs::path(UMBRAL_SOURCE_DIR) / path); }

std::string sphere_with(const std::string& before, const std::string& first)
{
    return before + R"(
namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
)" + first +
           R"(
    const glm::vec3 o = ray.origin - sphere.centre;
    const float a = dot(ray.direction, ray.direction);
    const float b = dot(o, ray.direction);
    const float d = b * b - a * (dot(o, o) - sphere.radius * sphere.radius);
    if (d < 0) return std::nullopt;
    for (const float t : {(-b - std::sqrt(d)) / a, (-b + std::sqrt(d)) / a})
        if (ray.t_min < t && t < ray.t_max) return t;
    return std::nullopt;
}

}
)";
}

}
