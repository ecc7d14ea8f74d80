#include "build/builder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "build/build_cache.hpp"
#include "build/check_names.hpp"
#include "build/compile.hpp"
#include "build/inspection.hpp"
#include "build/keeps_nothing.hpp"
#include "build/kept_builds.hpp"
#include "build/offered.hpp"
#include "model/caps.hpp"
#include "model/digest.hpp"
#include "model/recording.hpp"
#include "model/scratch.hpp"
#include "run/descriptor.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Which file this is: another one has another size, or was written at another time.
std::string stamp_of(const fs::path& file)
{
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    return missing ? "none\n" : fmt::format("{} {}\n", size, fs::last_write_time(file).time_since_epoch().count());
}

/// Everything that decides what a build gives: the precompiled header stands for those of all units, the unit's digest
/// for its interfaces; and the programs that refuse what is built.
std::string content_key(const Toolchain& tools, const Exercise& exercise, const Sources& files)
{
    const fs::path header = tools.student_header.string() + ".gch";
    std::string all = fmt::format("16\n{}\n{}\n{}{}{}{}\n{}\n{}\n{}\n", exercise.id, exercise.digest, exercise.gl,
                                  exercise.gl_calls, exercise.glfw, exercise.counts_work, tools.compiler,
                                  fmt::join(tools.flags, " "), fmt::join(exercise.forbid, " "));
    for (const fs::path& file : {header, tools.programs / "umbral-inspect", tools.programs / "assembler" / "as"})
        all += stamp_of(file);
    all +=
        read_text(unit_folder(tools, exercise.id) / "exports.txt") + read_text(tools.units / "framework-exports.txt");
    for (const std::string& used : exercise.uses)
        all += fmt::format("{}\n{}", used, read_text(unit_folder(tools, used) / "exports.txt"));
    for (const auto& [name, text] : files) all += fmt::format("{} {}\n{}\n", name, text.size(), text);
    return sha256_hex(std::as_bytes(std::span(all)));
}

/// Is there room on the disk for what compiling writes? Linkers do not always say that it was missing. Throws
/// std::runtime_error.
void require_room(const fs::path& folder)
{
    constexpr off_t bytes = off_t{8} << 20U;
    const fs::path file = folder / "room";
    const Descriptor probe(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR));
    const int failed = !probe ? errno : posix_fallocate(probe.get(), 0, bytes);
    std::error_code ignored;
    fs::remove(file, ignored);
    if (failed != 0)
        throw std::runtime_error(
            fmt::format("nothing can be compiled in {}: {}", folder.parent_path().string(), std::strerror(failed)));
}

/// For another attempt: of the one before nothing is left.
void empty(const ScratchFolder& work)
{
    for (const auto& entry : fs::directory_iterator(work.path())) fs::remove_all(entry.path());
}

/// Does this machine compile at all, now? A file that cannot fail, compiled like a student's. Throws std::runtime_error
/// with what the compiler says: then it is the machine that fails, and nobody's work.
void require_a_working_compiler(const Toolchain& tools, const Exercise& exercise)
{
    const ScratchFolder work(tools.cache);
    require_room(work.path());
    Toolchain unbounded = tools;
    unbounded.budget.reset();
    const Compilation canary =
        compile(unbounded, exercise, {{"canary.cpp", "int canary(int x) { return x + 1; }\n"}}, work.path());
    if (canary.outcome == Compilation::Outcome::built) return;
    throw std::runtime_error(fmt::format("the compiler fails on this machine, whatever it compiles: {}",
                                         one_line(canary.diagnostics, 1024)));
}

/// Compiles; if that fails without a word about the student's files, makes sure that it is not the machine, and
/// compiles once more. What a machine lacks may come and go (a limit of processes that others use up), so that the
/// files fail each time and those of the canary never: where the tools say again that they lack it, they are believed.
Compilation compile_surely(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                           const ScratchFolder& work)
{
    Compilation compilation = compile(tools, exercise, files, work.path());
    if (compilation.outcome != Compilation::Outcome::unexplained) return compilation;
    // With what the first attempt left on the disk: if it is full, it is full now.
    require_a_working_compiler(tools, exercise);
    const auto again = [&](Diagnostics diagnostics) {
        empty(work);
        return compile(tools, exercise, files, work.path(), UnusedCode::kept, diagnostics);
    };
    compilation = again(Diagnostics::plain);
    if (compilation.outcome != Compilation::Outcome::unexplained) return compilation;
    // Words of the files' own, in a message of the compiler's, may look like those of a tool in trouble.
    if (compilation.lacks_machine) {
        const Compilation heard = again(Diagnostics::json);
        if (heard.outcome == Compilation::Outcome::built) return heard;
        compilation.lacks_machine = heard.lacks_machine;
    }
    if (compilation.lacks_machine)
        throw std::runtime_error(fmt::format("the compiler lacks what this machine should give it: {}",
                                             one_line(compilation.diagnostics, 1024)));
    require_a_working_compiler(tools, exercise);
    return compilation;
}

/// Looking through the cache takes a while: done at a process's first new build, and again after many.
void prune_now_and_then(const Toolchain& tools)
{
    constexpr unsigned builds_between = 200;
    static std::atomic<unsigned> builds = 0;
    if (builds++ % builds_between == 0) prune_builds(tools.cache, tools.cache_bytes);
}

/// Sets the verdict on a library by what is in it. False if it could not be read.
bool look_at(const Toolchain& tools, const Exercise& exercise, const fs::path& library, Built& built)
{
    const auto inspection = inspect(tools, library, unit_folder(tools, exercise.id) / "exports.txt");
    if (!inspection) {
        built.verdict = Verdict::forbidden;
        built.message =
            "what your code compiles to cannot be read: it holds more names than are looked at, or damaged debug "
            "information";
        return false;
    }
    const auto objection = object_to(*inspection, offered_to(tools, exercise), exercise);
    built.verdict = objection ? objection->verdict : Verdict::ok;
    if (objection) built.message = printable(objection->message, caps::message);
    built.keeps_nothing = keeps_nothing(*inspection);
    return true;
}

/// Files were refused for what they use: is it used by the unit at all, or by functions that nothing calls?
Built without_unused_code(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                          const ScratchFolder& work, const Built& refused)
{
    empty(work);
    const Compilation compilation = compile(tools, exercise, files, work.path(), UnusedCode::left_out);
    Built built;
    if (compilation.library && look_at(tools, exercise, *compilation.library, built)) return built;
    built = refused;
    built.repeatable = compilation.outcome != Compilation::Outcome::too_expensive;
    return built;
}

/// A copy that was put aside in the same folder, as "sphere_old.cpp", defines what the unit's own file does: the first
/// file beside the unit's own without which the rest compiles is left out, and the message says so. Nothing if that is
/// not what is wrong, or if there are many such files.
std::optional<Built> without_a_copy(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                                    const ScratchFolder& work, const Compilation& refused)
{
    constexpr std::size_t most_tried = 3;
    if (refused.diagnostics.find("duplicate symbol") == std::string::npos) return std::nullopt;
    std::vector<std::string> beside;
    for (const auto& [name, text] : files)
        if (name.ends_with(".cpp") && std::ranges::find(exercise.files, name) == exercise.files.end())
            beside.push_back(name);
    if (beside.size() > most_tried) return std::nullopt;
    for (const std::string& copy : beside) {
        empty(work);
        Sources others = files;
        others.erase(copy);
        const Compilation compilation = compile(tools, exercise, others, work.path());
        Built built;
        // Whatever else is wrong without it, it was needed.
        if (!compilation.library || !look_at(tools, exercise, *compilation.library, built)) continue;
        if (built.verdict != Verdict::ok) continue;
        built.message = fmt::format("{} was left out: it defines what another of your files defines, too\n{}", copy,
                                    compilation.diagnostics);
        return built;
    }
    return std::nullopt;
}

Built compile_fresh(const Toolchain& tools, const Exercise& exercise, const Sources& files, const ScratchFolder& work)
{
    Built built;
    const Compilation compilation = compile_surely(tools, exercise, files, work);
    if (!compilation.library) {
        if (auto without = without_a_copy(tools, exercise, files, work, compilation)) return *std::move(without);
        built.verdict =
            compilation.outcome == Compilation::Outcome::not_allowed ? Verdict::forbidden : Verdict::compile_error;
        built.message = compilation.diagnostics;
        using Outcome = Compilation::Outcome;
        built.repeatable =
            compilation.outcome == Outcome::refused_by_compiler || compilation.outcome == Outcome::not_allowed;
        return built;
    }
    if (!look_at(tools, exercise, *compilation.library, built)) {
        require_a_working_compiler(tools, exercise);
        return built;
    }
    if (built.verdict == Verdict::ok) built.message = compilation.diagnostics;
    // Where work is counted, what reaches for the counter is refused as it was written, used or not.
    const bool may_be_unused = built.verdict == Verdict::forbidden && !exercise.counts_work;
    return may_be_unused ? without_unused_code(tools, exercise, files, work, built) : built;
}

/// The same, with the time that it took.
Built compile_measured(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                       const ScratchFolder& work)
{
    Toolchain measured = tools;
    if (!measured.budget) measured.budget = std::make_shared<UnitBudget>();
    const double before = measured.budget->taken();
    Built built = compile_fresh(measured, exercise, files, work);
    built.compile_seconds = measured.budget->taken() - before;
    return built;
}

}

Built build(const Toolchain& tools, const Exercise& exercise, const Sources& files)
{
    Built built;
    if (!exercise.is_cpp()) {
        const auto objection = check_words(files, exercise);
        built.verdict = objection ? objection->verdict : Verdict::ok;
        if (objection) built.message = objection->message;
        built.sources = files;
        return built;
    }
    const std::string key = content_key(tools, exercise, files);
    const fs::path folder = entry_of(tools.cache / "builds", key);
    if (auto result = kept(folder)) {
        mark_used(folder);
        built = *std::move(result);
        // As if it had been compiled now: what a submission gets depends on nobody else's.
        if (tools.budget) tools.budget->take(built.compile_seconds);
    } else {
        prune_now_and_then(tools);
        const ScratchFolder work(tools.cache);
        built = compile_measured(tools, exercise, files, work);
        if (built.repeatable) built = keep(built, work.path(), folder);
    }
    built.budget = tools.budget;
    built.sources = texts_of(files);
    built.files = files;
    return built;
}

Built adopt(const Toolchain& tools, const Exercise& exercise, const Sources& files, const fs::path& library)
{
    Built built;
    built.library = library;
    built.sources = texts_of(files);
    (void)look_at(tools, exercise, library, built);
    return built;
}

}
