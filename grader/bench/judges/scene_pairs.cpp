#include "bench/judges/scene_pairs.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <umbral/core/png.hpp>

#include "bench/judges/picture_operators.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {

void draw_scenes(const std::filesystem::path& program, const std::filesystem::path& folder, int side)
{
    std::string name = program.string();
    std::string target = folder.string();
    std::string option = fmt::format("--size={}", side);
    std::array<char*, 4> words{name.data(), target.data(), option.data(), nullptr};
    pid_t process = -1;
    int status = -1;
    if (const int failed = posix_spawn(&process, name.c_str(), nullptr, nullptr, words.data(), environ); failed != 0)
        throw std::runtime_error(fmt::format("cannot run {}: build the target umbral-bench-scenes", name));
    if (waitpid(process, &status, 0) != process || status != 0)
        throw std::runtime_error(fmt::format("{} did not draw its scenes into {}", name, target));
}

void visit_scenes(const std::filesystem::path& folder, const VisitPair& visit)
{
    const nlohmann::json list = read_json(folder / "pictures.json");
    for (const auto& scene : list.at("scenes")) {
        const auto name = scene.at("name").get<std::string>();
        const bool noise = scene.at("noise").get<bool>();
        const Picture expected = to_picture(read_png(folder / scene.at("expected").get<std::string>()));
        for (const auto& variant : scene.at("variants")) {
            const auto file = folder / variant.at("file").get<std::string>();
            Picture student = to_picture(read_png(file));
            if (student.width != expected.width || student.height != expected.height ||
                student.channels != expected.channels)
                throw std::runtime_error(fmt::format(
                    "{}: expected a picture of {} x {} with {} channels as the scene's own, got {} x {} with {}",
                    file.string(), expected.width, expected.height, expected.channels, student.width, student.height,
                    student.channels));
            visit({name, variant.at("operator").get<std::string>(), variant.at("harmful").get<bool>(), noise, false,
                   expected, std::move(student)});
        }
        if (!noise) visit_operators(name, expected, visit);
    }
}

}
