#include "attack/generators.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>

#include "attack/generators_texts.hpp"

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

fs::path unit(const fs::path& submission) { return submission / "raytracing" / "sphere"; }

void write(const fs::path& file, std::string_view text)
{
    fs::create_directories(file.parent_path());
    if (!(std::ofstream(file, std::ios::binary) << text).flush())
        throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", file.string()));
}

/// A link with the name of the unit's file.
void link_file(const fs::path& submission, const fs::path& to)
{
    fs::create_directories(unit(submission));
    fs::create_symlink(to, unit(submission) / "sphere.cpp");
}

void make_pipe(const fs::path& file)
{
    fs::create_directories(file.parent_path());
    if (mkfifo(file.c_str(), S_IRUSR | S_IWUSR) != 0)
        throw std::runtime_error(fmt::format("cannot make the pipe {}: {}", file.string(), std::strerror(errno)));
}

void make_socket(const fs::path& file)
{
    fs::create_directories(file.parent_path());
    // A socket's path has room for 107 bytes: it is made elsewhere, and moved.
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const fs::path near = fs::temp_directory_path() / fmt::format("umbral-socket-{}", getpid());
    std::strncpy(address.sun_path, near.c_str(), sizeof address.sun_path - 1);
    const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool good = made >= 0 && bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    if (made >= 0) close(made);
    if (good) {
        std::error_code other_disk;
        fs::rename(near, file, other_disk);
        fs::remove(near, other_disk);
    }
}

void link_chain(const fs::path& submission)
{
    link_file(submission, "link0");
    for (int i = 0; i < 60; ++i)
        fs::create_symlink(i == 59 ? fs::path("/etc/passwd") : fs::path(fmt::format("link{}", i + 1)),
                           unit(submission) / fmt::format("link{}", i));
}

void deep_tree(const fs::path& submission)
{
    // Deeper than a path may be long: folder by folder.
    int at = open(submission.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (int i = 0; at >= 0 && i < 2000; ++i) {
        if (mkdirat(at, "deeper", S_IRWXU) != 0) break;
        const int next = openat(at, "deeper", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        close(at);
        at = next;
    }
    if (at >= 0) close(at);
}

void many_files(const fs::path& submission)
{
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 1000; ++k)
            write(submission / fmt::format("folder{}", i) / fmt::format("file{}.txt", k), "");
}

void many_folders(const fs::path& submission)
{
    for (int i = 0; i < 200; ++i)
        for (int k = 0; k < 100; ++k)
            fs::create_directories(submission / fmt::format("a{}", i) / fmt::format("b{}", k));
}

void names_of_bytes(const fs::path& folder)
{
    for (const char* const name : {"\x1b[2J.cpp", "line\nfeed.hpp", "\xff\xfe.cpp", "<x-umbral onload=alert(1)>.hpp",
                                   "a\xe2\x80\xae"
                                   "b.cpp",
                                   "$(id).cpp", "`id`.hpp", "a b.cpp", "'\"\\.hpp"})
        write(folder / name, "int of_bytes = 1;\n");
}

void folders_of_bytes(const fs::path& submission)
{
    for (const char* const name : {"\x1b[2J", "line\nfeed", "\xff\xfe", "<x-umbral onload=alert(1)>"})
        write(submission / name / "sphere.cpp", "#error this is not it\n");
}

/// The submission gets another name within its class.
void rename_to(const fs::path& submission, const std::string& name)
{
    fs::rename(submission, submission.parent_path() / name);
}

struct Generator {
    std::string_view name;
    void (*make)(const fs::path& submission);
};

constexpr Generator generators[] = {
    {"link-to-itself", [](const fs::path& s) { fs::create_symlink("raytracing", s / "raytracing"); }},
    {"link-to-parent",
     [](const fs::path& s) {
         for (const char* const name : {"up", "again"}) fs::create_directory_symlink("..", s / name);
         fs::create_directory_symlink("../..", s / "raytracing" / "above");
     }},
    {"link-to-passwd", [](const fs::path& s) { link_file(s, "/etc/passwd"); }},
    {"link-to-neighbour",
     [](const fs::path& s) {
         fs::create_directories(s / "raytracing");
         fs::create_directory_symlink(s.parent_path() / "good-reference" / "raytracing" / "sphere", unit(s));
     }},
    {"hard-link-to-neighbour",
     [](const fs::path& s) {
         fs::create_directories(unit(s));
         fs::create_hard_link(unit(s.parent_path() / "good-reference") / "sphere.cpp", unit(s) / "sphere.cpp");
     }},
    {"dangling-link", [](const fs::path& s) { link_file(s, "nowhere"); }},
    {"link-chain", link_chain},
    {"link-to-device", [](const fs::path& s) { link_file(s, "/dev/zero"); }},
    {"no-rights-folder", [](const fs::path& s) { fs::permissions(unit(s), fs::perms::none); }},
    {"no-rights-file", [](const fs::path& s) { fs::permissions(unit(s) / "sphere.cpp", fs::perms::none); }},
    {"no-rights-submission", [](const fs::path& s) { fs::permissions(s, fs::perms::none); }},
    {"pipe", [](const fs::path& s) { make_pipe(unit(s) / "sphere.cpp"); }},
    {"pipe-as-helper",
     [](const fs::path& s) {
         make_pipe(unit(s) / "helper.cpp");
         make_pipe(s / "pipe.zip");
         make_socket(unit(s) / "other.hpp");
     }},
    {"socket", [](const fs::path& s) { make_socket(unit(s) / "sphere.cpp"); }},
    {"folder-as-file",
     [](const fs::path& s) {
         fs::create_directories(unit(s) / "sphere.cpp" / "sphere.cpp");
         write(s / "projections", "a file");
     }},
    {"many-files", many_files},
    {"many-folders", many_folders},
    {"deep-tree", deep_tree},
    {"many-candidates",
     [](const fs::path& s) {
         for (int i = 0; i < 300; ++i)
             write(s / fmt::format("try{}", i) / "sphere.cpp", fmt::format("int number = {};\n", i));
     }},
    {"huge-file",
     [](const fs::path& s) {
         write(unit(s) / "sphere.cpp", "");
         fs::resize_file(unit(s) / "sphere.cpp", std::uintmax_t{1} << 40U);
     }},
    {"names-of-bytes", [](const fs::path& s) { names_of_bytes(unit(s)); }},
    {"folders-of-bytes", folders_of_bytes},
    {"two-cases",
     [](const fs::path& s) {
         write(unit(s) / "Sphere.cpp", "#error not this one\n");
         write(s / "Raytracing" / "SPHERE" / "sphere.cpp", "#error nor this one\n");
     }},
    {"renamed-class-json", [](const fs::path& s) { rename_to(s, "class.json"); }},
    {"renamed-index-html", [](const fs::path& s) { rename_to(s, "index.html"); }},
    {"renamed-report-json", [](const fs::path& s) { rename_to(s, "report.json"); }},
    {"renamed-marker", [](const fs::path& s) { rename_to(s, "umbral-reports.json"); }},
    {"renamed-temporary", [](const fs::path& s) { rename_to(s, "class.json.tmp-1-0"); }},
    {"renamed-pictures", [](const fs::path& s) { rename_to(s, "pictures"); }},
    {"renamed-dots", [](const fs::path& s) { rename_to(s, "..x"); }},
    {"renamed-option", [](const fs::path& s) { rename_to(s, "-oX"); }},
    {"renamed-newline", [](const fs::path& s) { rename_to(s, "line\nfeed"); }},
    {"renamed-escapes", [](const fs::path& s) { rename_to(s, "\x1b[2J\x1b]0;owned\x07"); }},
    {"renamed-markup", [](const fs::path& s) { rename_to(s, "<x-umbral onload=alert(1)>"); }},
    {"renamed-broken", [](const fs::path& s) { rename_to(s, "\xff\xfe\xc3"); }},
    {"renamed-long", [](const fs::path& s) { rename_to(s, std::string(255, 'n')); }},
    {"renamed-formula", [](const fs::path& s) { rename_to(s, "=cmd|'calc'!A0"); }},
    {"renamed-backslash", [](const fs::path& s) { rename_to(s, "a'b\"c\\d$(id)`id`;&"); }},
    {"renamed-right-to-left",
     [](const fs::path& s) {
         rename_to(s,
                   "a\xe2\x80\xae"
                   "b");
     }},
    {"renamed-like-another",
     [](const fs::path& s) {
         rename_to(s,
                   "Good-R\xc3\xa9"
                   "ference");
     }},
    {"renamed-file-beside",
     [](const fs::path& s) {
         rename_to(s, "beside");
         fs::create_symlink("/etc", s.parent_path() / "link-beside");
         write(s.parent_path() / "file-beside.txt", "no submission");
     }},
};

const Generator* generator_named(std::string_view name)
{
    const auto found = std::ranges::find(generators, name, &Generator::name);
    return found == std::end(generators) ? nullptr : found;
}

}

bool has_generator(std::string_view name) { return generator_named(name) != nullptr || has_text_generator(name); }

void generate(std::string_view name, const fs::path& submission)
{
    if (has_text_generator(name)) return generate_text(name, submission);
    const Generator* one = generator_named(name);
    if (one == nullptr) throw std::runtime_error(fmt::format("there is no generator '{}'", name));
    one->make(submission);
}

}
