#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "collect/class_folder.hpp"
#include "collect/handed.hpp"
#include "collect/submission_id.hpp"
#include "fuzz.hpp"
#include "model/scratch.hpp"

// The walk over what was handed in: the bytes are a script that fills a folder. Lines: "d PATH" a folder, "l PATH" a
// link to the path that the next line names, "p PATH" a pipe, "c PATH" a closed folder, anything else a file of that
// name with the next line in it.
namespace {

using namespace umbral;
namespace fs = std::filesystem;

constexpr int most_entries = 32;

/// Below `root` whatever the line says: parts that would lead out are left out.
fs::path below(const fs::path& root, std::string_view line)
{
    fs::path path = root;
    int depth = 0;
    for (const fs::path& part : fs::path(line.substr(0, 200)).relative_path())
        if (part != ".." && part.string().find('\0') == std::string::npos && ++depth <= 8) path /= part;
    return path;
}

void fill(const fs::path& root, std::string_view script)
{
    std::error_code error;
    std::vector<std::pair<fs::path, std::string>> links;
    const auto next = [&] {
        const std::string_view line = script.substr(0, script.find('\n'));
        script.remove_prefix(std::min(script.size(), line.size() + 1));
        return line;
    };
    for (int i = 0; i < most_entries && !script.empty(); ++i) {
        const std::string_view line = next();
        const fs::path path = below(root, line.size() > 2 ? line.substr(2) : line);
        if (path == root) continue;
        fs::create_directories(path.parent_path(), error);
        if (line.starts_with("d "))
            fs::create_directories(path, error);
        else if (line.starts_with("c ")) {
            fs::create_directories(path, error);
            fs::permissions(path, fs::perms::none, error);
        } else if (line.starts_with("p "))
            (void)mkfifo(path.c_str(), 0600);
        else if (line.starts_with("l ")) {
            links.emplace_back(path, next().substr(0, 100));
        } else if (!fs::exists(fs::symlink_status(path, error)))
            std::ofstream(path, std::ios::binary) << next();
    }
    // Last: nothing of the above may be written through a link, which leads anywhere.
    for (const auto& [path, target] : links) (void)symlink(target.c_str(), path.c_str());
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const grader::ScratchFolder folder(fs::temp_directory_path());
    fill(folder.path(), tests::text_of(data, size));
    for (const grader::SubmissionFolder& one : grader::class_folder(folder.path()).submissions) {
        tests::expect(grader::is_submission_id(one.id) && !grader::is_reserved_id(one.id), "an id that is none");
        (void)grader::read_submission(one.folder, {});
    }
    grader::Exercise exercise;
    exercise.id = "raytracing/sphere";
    exercise.topic = "raytracing";
    exercise.name = "sphere";
    exercise.files = {"sphere.cpp"};
    const grader::SubmittedFiles submitted = grader::read_submission(folder.path(), {&exercise, 1});
    for (const auto& [path, text] : submitted.files)
        tests::expect(!path.empty() && path.front() != '/', "an absolute path");
    try {
        const grader::Handed handed = grader::collect(submitted, exercise);
        for (const auto& [name, text] : handed.files)
            tests::expect(!name.empty() && name.front() != '-' && name.find('/') == std::string::npos,
                          "a name that a compiler takes for something else");
    } catch (const std::runtime_error&) {
        // The unit of this test has no stub on the disk.
    }
    return 0;
}
