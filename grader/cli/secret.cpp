#include "cli/secret.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/application.hpp"
#include "model/random_text.hpp"
#include "run/descriptor.hpp"
#include "text/escape.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t shortest = 16;
constexpr std::size_t longest = 4096;

[[noreturn]] void refuse_secret(const fs::path& file, const std::string& reason)
{
    throw UsageError(fmt::format("the secret {}: {}", file.string(), reason));
}

[[noreturn]] void refuse_secret_for_errno(const fs::path& file, const char* action)
{
    refuse_secret(file, fmt::format("cannot {} it: {}", action, std::strerror(errno)));
}

fs::path default_file()
{
    if (const char* xdg = std::getenv("XDG_CONFIG_HOME"); xdg != nullptr && *xdg == '/')
        return fs::path(xdg) / "umbral" / "secret";
    if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
        return fs::path(home) / ".config" / "umbral" / "secret";
    throw UsageError(
        "neither XDG_CONFIG_HOME nor HOME is set: name a file for the secret of hidden cases with --secret-file");
}

/// `folder`, or the first of those above it that exists.
fs::path nearest_existing(fs::path folder)
{
    std::error_code error;
    while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    return folder;
}

void expect_folder_of(const fs::path& file)
{
    std::error_code error;
    if (fs::is_directory(file.parent_path(), error)) return;
    refuse_secret(
        file,
        fmt::format(
            "expected its folder to exist; of that path there is only {}. Make the folder, or correct --secret-file",
            nearest_existing(file.parent_path()).string()));
}

/// A file beside the one that is meant, removed at the end: what is half written is never taken for the secret.
class Draft {
public:
    explicit Draft(const fs::path& file) : name_(file.string() + ".XXXXXX")
    {
        descriptor_ = Descriptor(mkostemp(name_.data(), O_CLOEXEC));
        if (!descriptor_) refuse_secret_for_errno(file, "make");
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() { (void)unlink(name_.c_str()); }

    /// Gives `text` the name `file`. Returns false if that exists by now.
    [[nodiscard]] bool publish(const std::string& text, const fs::path& file) const
    {
        const ssize_t written = write(descriptor_.get(), text.data(), text.size());
        if (written >= 0 && written != static_cast<ssize_t>(text.size())) errno = ENOSPC;
        if (written != static_cast<ssize_t>(text.size()) || fsync(descriptor_.get()) != 0)
            refuse_secret_for_errno(file, "write");
        if (link(name_.c_str(), file.c_str()) == 0) return true;
        if (errno != EEXIST) refuse_secret_for_errno(file, "make");
        return false;
    }

private:
    std::string name_;
    Descriptor descriptor_;
};

void make(const fs::path& file)
{
    if (Draft(file).publish(random_text(), file))
        fmt::print(stderr,
                   "umbral: made a new secret for the hidden cases: {}\n        Keep it: with another one, grading "
                   "again gives other hidden inputs.\n",
                   escape_terminal(file.string()));
}

void warn_of_readers(const fs::path& file, mode_t mode)
{
    if ((mode & (S_IRWXG | S_IRWXO)) == 0) return;
    const std::string name = escape_terminal(file.string());
    fmt::print(
        stderr,
        "umbral: warning: other users can read or change the secret of the hidden cases; `chmod 600 {}` stops that\n",
        name);
}

std::string read_secret(const fs::path& file)
{
    const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat status {};
    if (!opened || fstat(opened.get(), &status) != 0) refuse_secret_for_errno(file, "read");
    if (!S_ISREG(status.st_mode)) refuse_secret(file, "expected a regular file, got another kind");
    std::string text(longest + 1, '\0');
    const ssize_t got = read(opened.get(), text.data(), text.size());
    if (got < 0) refuse_secret_for_errno(file, "read");
    text.resize(static_cast<std::size_t>(got));
    if (text.size() < shortest)
        refuse_secret(file, fmt::format("expected at least {} characters, got {}", shortest, text.size()));
    if (text.size() > longest) refuse_secret(file, fmt::format("expected at most {} bytes, got more", longest));
    warn_of_readers(file, status.st_mode);
    return text;
}

}

std::string secret_from(const std::string& named)
{
    const fs::path file = named.empty() ? default_file() : fs::absolute(named);
    std::error_code error;
    if (named.empty()) {
        fs::create_directories(file.parent_path(), error);
        if (error)
            refuse_secret(
                file, fmt::format("cannot make its folder: {}. Name another file with --secret-file", error.message()));
    }
    expect_folder_of(file);
    if (!fs::exists(file, error)) make(file);
    return read_secret(file);
}

}
