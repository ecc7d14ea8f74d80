#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/hand_over.hpp"
#include "report/paint.hpp"
#include "worker/fingerprint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// One thing that Umbral needs or would like, whether it is there, and what to do if not.
struct Symptom {
    std::string name;
    bool present = false;
    bool needed = true;
    std::string detail;  ///< what was found
    std::string remedy;  ///< what to do if it is missing
};

bool on_path(const std::string& program)
{
    return std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) == 0;
}

Symptom protection(const std::vector<std::string>& active, const std::string& name, bool needed,
                   const std::string& remedy)
{
    const auto found =
        std::find_if(active.begin(), active.end(), [&](const std::string& one) { return one.starts_with(name); });
    return {"sandbox: " + name, found != active.end(), needed, found != active.end() ? *found : "", remedy};
}

void examine_spawners(const Application& application, std::vector<Symptom>& symptoms)
{
    Worker worker(application.tools);
    try {
        const auto& active = worker.spawner(false).protections();
        symptoms.push_back(protection(
            active, "seccomp", false,
            "grade only work that you trust: this kernel does not filter system calls (CONFIG_SECCOMP_FILTER)"));
        symptoms.push_back(protection(
            active, "landlock", false,
            "grade only work that you trust: use Linux 5.13 or newer, with landlock in the kernel's lsm= list"));
        for (const char* name : {"user namespace", "network namespace", "process namespace"})
            symptoms.push_back(
                protection(active, name, false,
                           "optional: allow unprivileged user namespaces (sysctl kernel.unprivileged_userns_clone=1)"));
    } catch (const std::exception& error) {
        symptoms.push_back({"sandbox", false, true, error.what(), "build again: ./umbral test says what fails"});
    }
}

/// One back end draws all there is to draw; the other is there for systems that lack the first.
void examine_back_ends(const Application& application, std::vector<Symptom>& symptoms)
{
    struct BackEnd {
        const char* choice;
        const char* name;
        const char* remedy;
    };
    std::vector<Symptom> found;
    for (const BackEnd& one : {BackEnd{"osmesa", "OpenGL by OSMesa",
                                       "apt install libosmesa6 (not in Mesa 25.1 and later: EGL draws the same there)"},
                               BackEnd{"egl", "OpenGL by EGL", "apt install libegl1 libegl-mesa0 libgl1-mesa-dri"}}) {
        try {
            found.push_back({one.name, true, false,
                             Spawner(application.tools.programs / "umbral-spawner-gl", one.choice).gl(), ""});
        } catch (const std::exception&) {
            found.push_back({one.name, false, false, "", one.remedy});
        }
    }
    const bool none = std::none_of(found.begin(), found.end(), [](const Symptom& one) { return one.present; });
    for (Symptom& one : found) one.needed = none;
    symptoms.insert(symptoms.end(), found.begin(), found.end());
    try {
        symptoms.push_back(
            {"OpenGL offscreen", true, true, Spawner(application.tools.programs / "umbral-spawner-gl").gl(), ""});
    } catch (const std::exception&) {
        symptoms.push_back({"OpenGL offscreen", false, true, "",
                            none ? "install one of the two above"
                                 : "UMBRAL_GL must be osmesa or egl, and name one that is installed"});
    }
}

std::vector<Symptom> examine(const Application& application)
{
    std::vector<Symptom> symptoms;
    const std::string compiler = version_of(application.tools.compiler);
    symptoms.push_back({"compiler", !compiler.empty(), true, compiler, "apt install g++"});
    symptoms.push_back({"linker mold", on_path("mold"), true, "", "apt install mold"});
    const fs::path header = application.tools.student_header.string() + ".gch";
    const bool installed = application.layout.installed;
    symptoms.push_back({"precompiled header", fs::exists(header), !installed, header.string(),
                        installed ? "made at first use" : "build again: ./umbral list"});
    symptoms.push_back({"debugger gdb", on_path("gdb"), false, "", "for `umbral debug`: apt install gdb"});
    const fs::path& cache = application.tools.cache;
    std::error_code error;
    fs::create_directories(cache, error);
    symptoms.push_back({"cache", !error && access(cache.c_str(), W_OK) == 0, true, cache.string(),
                        "make this folder writable, or set UMBRAL_CACHE to one that is"});
    examine_spawners(application, symptoms);
    examine_back_ends(application, symptoms);
    return symptoms;
}

}

void add_doctor(Command command, Application& application)
{
    auto json = std::make_shared<bool>(false);
    auto attack = std::make_shared<bool>(false);
    command.flag("--json", *json, "As JSON");
    command
        .flag("--attack", *attack,
              "Instead: grades hostile submissions that do no harm, and says of each whether this machine held")
        .excludes("--json");
    command.runs([&application, json, attack] {
        if (*attack) hand_over_to_authors(application, {"doctor", "--attack"});
        const std::vector<Symptom> symptoms = examine(application);
        const Paint paint(application.style);
        nlohmann::json rows = nlohmann::json::array();
        for (const Symptom& symptom : symptoms) {
            if (!symptom.present && symptom.needed) application.exit_status = exit_not_right;
            rows.push_back({{"name", symptom.name},
                            {"present", symptom.present},
                            {"needed", symptom.needed},
                            {"detail", symptom.detail},
                            {"remedy", symptom.present ? "" : symptom.remedy}});
            if (*json) continue;
            const std::string mark = symptom.present  ? paint(Tone::good, paint.symbol("✓", "ok"))
                                     : symptom.needed ? paint(Tone::bad, paint.symbol("✗", "NO"))
                                                      : paint(Tone::part, paint.symbol("○", "--"));
            fmt::print("{} {:<30} {}\n", mark, symptom.name,
                       paint.safe(symptom.present ? symptom.detail : symptom.remedy));
        }
        if (*json)
            fmt::print("{}\n", nlohmann::json{{"format", "umbral-doctor"}, {"version", 1}, {"symptoms", rows}}.dump(2));
    });
}

}
