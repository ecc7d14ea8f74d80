#include "build/compiler_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// What the compiler says to a question such as "-print-file-name=crti.o".
std::string answer(const std::string& compiler, const std::string& question)
{
    // The compiler's name comes from the build's own configuration, never from a submission.
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((compiler + " " + question + " 2>/dev/null").c_str(), "re"), &pclose);
    std::array<char, 4096> line{};
    if (!pipe || std::fgets(line.data(), line.size(), pipe.get()) == nullptr) return "";
    std::string text(line.data());
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

std::vector<std::string> ask(const std::string& compiler)
{
    // The compiler's own folder holds "include"; crti.o lies beside the system's libraries.
    const fs::path own = answer(compiler, "-print-file-name=include");
    const fs::path start = answer(compiler, "-print-file-name=crti.o");
    if (!own.is_absolute() || !start.is_absolute())
        throw std::runtime_error(fmt::format("the compiler {} does not say where its files lie; `umbral doctor` says what is missing", compiler));
    const fs::path libraries = fs::canonical(start).parent_path();
    return {fs::canonical(own.parent_path()).string(), own.parent_path().lexically_normal().string(), libraries.string() + "/*", "/usr/include", "/usr/bin/*"};
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
