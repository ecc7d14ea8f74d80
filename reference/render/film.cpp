#include "render/film.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace umbral::render {
namespace {

namespace fs = std::filesystem;

/// Runs a program with the process's own input and output; its exit status, or -1 if it did not end by itself.
int run(const std::vector<std::string>& words)
{
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        execvp(arguments.front(), arguments.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

/// ffmpeg reads "%" in names of files as the place of the number.
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char letter : text) result += letter == '%' ? std::string("%%") : std::string(1, letter);
    return result;
}

}

std::string numbered(const std::string& out, int number)
{
    const fs::path path(out);
    const fs::path name = path.stem().string() + fmt::format("-{:04}", number) + path.extension().string();
    return (path.parent_path() / name).string();
}

float film_seconds(const FilmOptions& options, const scene::Scene& scene)
{
    const float seconds = options.seconds > 0 ? options.seconds : scene.seconds;
    if (!(seconds > 0))
        throw std::runtime_error("--animate: the scene does not say how many seconds it lasts; add --seconds S");
    return seconds;
}

bool has_ffmpeg()
{
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
    return false;
}

void join_pictures(const FilmOptions& options, float seconds, const std::string& out)
{
    if (!has_ffmpeg())
        throw std::runtime_error(
            "--film needs ffmpeg, which is not installed (Debian: apt-get install ffmpeg). The numbered pictures are "
            "written.");
    const fs::path path(out);
    const fs::path pattern =
        path.parent_path() / (escaped(path.stem().string()) + "-%04d" + escaped(path.extension().string()));
    // Names that begin with a hyphen are files here, and no options.
    const std::string film = options.film.starts_with('-') ? "./" + options.film : options.film;
    const int status = run({"ffmpeg", "-loglevel", "error", "-nostdin", "-y", "-framerate",
                            fmt::format("{}", static_cast<double>(options.pictures) / seconds), "-i",
                            (path.is_relative() ? fs::path(".") / pattern : pattern).string(), "-pix_fmt", "yuv420p",
                            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", film});
    if (status != 0) throw std::runtime_error(fmt::format("ffmpeg ended with status {}: no film was made", status));
}

std::string progress_text(double done, double seconds)
{
    std::string text = fmt::format("{:.0f} %", 100 * done);
    if (done > 0 && done < 1) text += fmt::format(", {:.0f} s left", std::ceil(seconds * (1 - done) / done));
    return text;
}

void Progress::tell(double done)
{
    const Clock::time_point now = Clock::now();
    if (!shown_ || (done < 1 && told_ && now - last_ < std::chrono::milliseconds(100))) return;
    last_ = now;
    told_ = true;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    // Spaces over what was longer before.
    (void)std::fprintf(stderr, "\r%-30s", progress_text(done, seconds).c_str());
    (void)std::fflush(stderr);
}

Progress::~Progress()
{
    if (told_) (void)std::fputc('\n', stderr);
}

}
