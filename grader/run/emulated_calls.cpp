#include "run/emulated_calls.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace umbral::grader::emulated_calls {
namespace {

struct Library {
    const char* path = nullptr;
    int descriptor = -1;
};
// A signal handler has no argument of ours. The student's code can overwrite this: all that it holds are numbers of
// files that are open in this process anyway.
std::array<Library, 3> libraries;

// The path may point anywhere: a crash here is the student's, as it would be in the kernel's place.
std::optional<std::int64_t> open_library(const Arguments& arguments)
{
    const auto* path = reinterpret_cast<const char*>(arguments[1]);
    if ((arguments[2] & static_cast<std::uint64_t>(O_ACCMODE | O_CREAT | O_TRUNC)) != O_RDONLY) return std::nullopt;
    for (Library& library : libraries) {
        if (library.path == nullptr || std::strcmp(library.path, path) != 0) continue;
        library.path = nullptr;
        return library.descriptor;
    }
    return std::nullopt;
}

std::optional<std::int64_t> state_of_file(const Arguments& arguments)
{
    const auto* path = reinterpret_cast<const char*>(arguments[1]);
    if ((arguments[3] & AT_EMPTY_PATH) == 0 || *path != 0) return std::nullopt;
    const auto descriptor = static_cast<int>(arguments[0]);
    // AT_FDCWD would name the working directory, which is no open file.
    return syscall(SYS_fstat, descriptor, arguments[2]) == 0 ? 0 : -std::int64_t{errno};
}

}

void hand_out_once(const char* path, int descriptor) noexcept
{
    for (Library& library : libraries)
        if (library.path == nullptr) {
            library = {path, descriptor};
            return;
        }
}

std::optional<std::int64_t> answer(std::uint32_t call, const Arguments& arguments) noexcept
{
    if (call == SYS_openat) return open_library(arguments);
    if (call == SYS_newfstatat) return state_of_file(arguments);
    return std::nullopt;
}

}
