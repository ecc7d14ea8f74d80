#include "build/compiler_files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <stdexcept>

#include "build/ask_program.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

// What the C++ and C libraries, OpenGL, GLFW and GLM have in folders of their own below one of headers. Other libraries
// that happen to be installed are not there: Eigen would solve what a unit teaches, and only on some machines.
constexpr std::array header_folders{"c++",   "bits", "sys", "gnu",  "asm", "asm-generic",
                                    "linux", "glm",  "GL",  "GLFW", "KHR"};

std::vector<std::string> ask(const std::string& compiler)
{
    // The compiler's own folder holds "include"; crti.o lies beside the system's libraries.
    const fs::path own = ask_program(compiler, "-print-file-name=include");
    const fs::path start = ask_program(compiler, "-print-file-name=crti.o");
    if (!own.is_absolute() || !start.is_absolute())
        throw std::runtime_error(fmt::format(
            "the compiler {} does not say where its files lie; `umbral doctor` says what is missing", compiler));
    const fs::path libraries = fs::canonical(start).parent_path();
    std::vector<std::string> rules{fs::canonical(own.parent_path()).string(),
                                   own.parent_path().lexically_normal().string(), libraries.string() + "/*",
                                   "/usr/bin/*"};
    // Debian has what differs by architecture in a folder named as the libraries' one.
    const fs::path headers = "/usr/include";
    for (const fs::path& folder : {headers, headers / libraries.filename()}) {
        rules.push_back(folder.string() + "/*");
        for (const char* name : header_folders) rules.push_back((folder / name).string());
    }
    return rules;
}

}

const std::vector<std::string>& compiler_files(const std::string& compiler)
{
    static std::mutex mutex;
    static std::map<std::string, std::vector<std::string>> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(compiler);
    return found != known.end() ? found->second : known.emplace(compiler, ask(compiler)).first->second;
}

}
