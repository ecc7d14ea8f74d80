#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/workbench.hpp"

namespace umbral::grader::test {

/// Files whose build, as it lies in the cache, holds other code: `text`, compiled without what the builder refuses
/// (assembler, say). As if somebody had found a way around that: what stands behind it must hold all the same.
[[nodiscard]] inline Sources planted(const Workbench& bench, const std::string& text)
{
    const Sources innocent{
        {"sphere.cpp", sphere_with("// " + std::to_string(std::hash<std::string>{}(text)) + "\n", "")}};
    const Built built = build(bench.tools(), bench.exercise("raytracing/sphere"), innocent);
    std::filesystem::copy_file(bench.compile_sphere(text), built.library,
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream(built.library.parent_path() / "result.json") << nlohmann::json{
        {"verdict", "ok"},
        {"message", ""},
        {"compile_seconds", 0},
        {"keeps_nothing", false},
        {"bytes", std::filesystem::file_size(built.library)}}.dump();
    return innocent;
}

}
