#include "attack/trial.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <stdexcept>

#include "attack/generators.hpp"
#include "text/json_file.hpp"

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

constexpr const char* reference_id = "good-reference";
constexpr std::pair<const char*, const char*> samples[] = {{"good-diego", "diego-different"},
                                                           {"good-carla", "carla-typical-mistakes"}};

/// The reference as a student would hand it in, for each of the units.
void hand_in_reference(const Target& target, const std::vector<std::string>& units, const fs::path& submission,
                       const std::string& comment = "")
{
    for (const std::string& unit : units) {
        const fs::path topic = fs::path(unit).parent_path();
        const nlohmann::json manifest = read_json(target.exercises / unit / "exercise.json");
        fs::create_directories(submission / unit);
        for (const std::string name : manifest.at("files")) {
            const fs::path beside = target.reference / unit / name;
            fs::copy_file(fs::exists(beside) ? beside : target.reference / topic / name, submission / unit / name);
            std::ofstream(submission / unit / name, std::ios::app) << comment;
        }
    }
}

/// What an attacker cannot know, told all the same: @SECRET@ and its like in sources become paths of this very grading.
std::string with_places(std::string text, const Target& target, const fs::path& scratch)
{
    const std::pair<std::string_view, fs::path> places[] = {{"@SECRET@", scratch / "secret"},
                                                            {"@REFERENCE@", target.reference},
                                                            {"@NEIGHBOUR@", scratch / "class" / reference_id},
                                                            {"@SCRATCH@", scratch}};
    for (const auto& [word, path] : places)
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + path.native().size()))
            text.replace(at, word.size(), path.native());
    return text;
}

void copy_attack(const Attack& attack, const Target& target, const fs::path& scratch)
{
    const fs::path submission = scratch / "class" / attack.id();
    fs::create_directories(submission);
    for (const auto& entry : fs::recursive_directory_iterator(attack.folder)) {
        const fs::path to = submission / entry.path().lexically_relative(attack.folder);
        if (entry.path().filename() == "attack.json") continue;
        if (entry.is_directory()) {
            fs::create_directories(to);
        } else if (!(std::ofstream(to, std::ios::binary) << with_places(bytes_of_file(entry.path()), target, scratch))
                        .flush()) {
            throw std::runtime_error(fmt::format("cannot write {}: is the disk full?", to.string()));
        }
    }
    if (!attack.make.empty()) generate(attack.make, submission);
}

void give_to_nobody(const fs::path& folder)
{
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        // Trees may be deeper than a path may be long: what lies there stays another user's.
        if (lchown(at->path().c_str(), nobody, nobody) != 0 && errno != ENAMETOOLONG)
            throw std::runtime_error(
                fmt::format("cannot give {} to nobody: {}", at->path().string(), std::strerror(errno)));
    if (lchown(folder.c_str(), nobody, nobody) != 0)
        throw std::runtime_error(fmt::format("cannot give {} to nobody", folder.string()));
}

void read_results(Graded& graded)
{
    graded.class_json = nlohmann::json::parse(bytes_of_file(graded.out / "class.json"), nullptr, false);
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(graded.out, error)) {
        nlohmann::json report = nlohmann::json::parse(bytes_of_file(entry.path() / "report.json"), nullptr, false);
        if (report.is_object() && report.contains("submission"))
            graded.reports[entry.path().filename().string()] = std::move(report["submission"]);
    }
}

}

std::string Graded::how_it_ended() const
{
    if (run.timed_out) return fmt::format("grading did not end within {:.0f} s", run.seconds);
    const std::string last = run.printed.size() > 400 ? run.printed.substr(run.printed.size() - 400) : run.printed;
    if (run.signal != 0)
        return fmt::format("signal {} ({}) ended the grader; the last it said: {}", run.signal, strsignal(run.signal),
                           last);
    if (run.status != 0) return fmt::format("the grader ended with status {}; the last it said: {}", run.status, last);
    return class_json.is_object() ? "" : "there is no class.json";
}

std::vector<std::string> good_ids()
{
    std::vector<std::string> ids{reference_id};
    for (const auto& [id, folder] : samples) ids.emplace_back(id);
    return ids;
}

std::vector<std::string> units_of(std::span<const Attack> attacks)
{
    std::set<std::string> units;
    for (const Attack& attack : attacks)
        for (const auto& [unit, expected] : attack.units) units.insert(unit);
    return {units.begin(), units.end()};
}

Graded grade_beside_good(const Target& target, const Setting& setting, std::span<const Attack> attacks,
                         const std::vector<std::string>& units, const fs::path& scratch, double seconds)
{
    Graded graded;
    graded.submissions = scratch / "class";
    graded.out = scratch / "out";
    graded.source = target.exercises.parent_path();
    graded.secret = "5ec7e75ec7e75ec7e75ec7e75ec7e75ec7e75ec7e7";
    for (const char* const name : {"class", "cache", "home", "tmp"}) fs::create_directories(scratch / name);
    std::ofstream(scratch / "secret") << graded.secret;
    fs::permissions(scratch / "secret", fs::perms::owner_read | fs::perms::owner_write);
    hand_in_reference(target, units, graded.submissions / reference_id);
    for (int i = 0; i < target.more_good; ++i)
        hand_in_reference(target, units, graded.submissions / fmt::format("more-{}", i),
                          fmt::format("\n// of number {}\n", i));
    for (const auto& [id, folder] : samples)
        fs::copy(target.sample_class / folder, graded.submissions / id, fs::copy_options::recursive);
    for (const Attack& attack : attacks) copy_attack(attack, target, scratch);
    if (setting.as_nobody) give_to_nobody(scratch);

    Call call;
    call.words = {target.umbral.string(),
                  "grade",
                  graded.submissions.string(),
                  "--out",
                  graded.out.string(),
                  "--secret-file",
                  (scratch / "secret").string(),
                  "--jobs",
                  "8"};
    for (const std::string& unit : units) call.words.insert(call.words.end(), {"--unit", unit});
    call.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "HOME=" + (scratch / "home").string(),
                        "TMPDIR=" + (scratch / "tmp").string(), "UMBRAL_CACHE=" + (scratch / "cache").string()};
    if (!setting.gl.empty()) call.environment.push_back("UMBRAL_GL=" + setting.gl);
    call.output = scratch / "printed.txt";
    call.seconds = seconds;
    call.before = [&] { enter(setting); };
    graded.run = run_measured(call);
    read_results(graded);
    graded.cache_kib = disk_kib(scratch / "cache");
    graded.reports_kib = disk_kib(graded.out);
    return graded;
}

}
