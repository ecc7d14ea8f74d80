#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <umbral/record/driver.hpp>
#include <umbral/record/questions.hpp>
#ifdef UMBRAL_WITH_GL
#include <umbral/gl/context.hpp>
#endif

// umbral-debug DRIVER STUDENT CASE SEED SOURCES [QUESTION]: the student's own code in an ordinary program, with what it
// records listed at the end. At this question, counted from 0, umbral::question_reached() is called.
namespace {

using namespace umbral;

void* load(const char* path)
{
    void* handle = dlopen(path, RTLD_LAZY | RTLD_GLOBAL);
    if (handle == nullptr) throw std::runtime_error(dlerror());
    return handle;
}

std::map<std::string, std::string, std::less<>> texts_in(const std::filesystem::path& folder)
{
    std::map<std::string, std::string, std::less<>> texts;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        if (entry.is_regular_file()) texts[entry.path().filename().string()] = text.str();
    }
    return texts;
}

void run(char** words)
{
#ifdef UMBRAL_WITH_GL
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
#endif
    if (*words[2] != 0) load(words[2]);
    const auto* driver = static_cast<const Driver*>(dlsym(load(words[1]), "_ZN6umbral6driverE"));
    const std::uint64_t stream = std::strtoull(words[4], nullptr, 10);
    Case what{words[3], Random(stream), texts_in(words[5]), Variation(stream)};
    Questions questions({.stop = words[6] == nullptr ? std::nullopt : std::optional(std::stoul(words[6]))});
    Recorder recorder = words[6] == nullptr ? Recorder() : Recorder(questions);
    for (const DriverCase& one : driver->cases)
        if (what.name == one.name) one.run(what, recorder);
    for (const auto& [name, tensor] : recorder.tensors())
        std::printf("recorded %s: %u x %u cells of %u components\n", name.c_str(), tensor.rows, tensor.columns,
                    tensor.components);
}

}

int main(int count, char** words)
{
    if (count != 6 && count != 7) {
        (void)std::fputs("usage: umbral-debug DRIVER STUDENT CASE SEED SOURCES [QUESTION] (called by `umbral debug`)\n",
                         stderr);
        return 2;
    }
    try {
        run(words);
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
