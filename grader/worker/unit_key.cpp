#include "worker/unit_key.hpp"

#include <algorithm>
#include <filesystem>

#include "model/digest.hpp"
#include "worker/packaged_unit.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

void add_file(Sha256& hash, const fs::path& file)
{
    std::error_code missing;
    hash.update_field(file.string());
    hash.update(std::uint64_t{fs::file_size(file, missing)});
    if (!missing) hash.update(static_cast<std::uint64_t>(fs::last_write_time(file).time_since_epoch().count()));
}

/// All regular files below a folder, which may be missing, by name.
void add_folder(Sha256& hash, const fs::path& folder)
{
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    hash.update(std::uint64_t{files.size()});
    for (const fs::path& file : files) add_file(hash, file);
}

/// The programs that a result comes from; the engine's and the debugger's are not among them.
constexpr const char* programs[] = {"umbral",         "umbral-confine",    "umbral-inspect", "assembler/as",
                                    "umbral-spawner", "umbral-spawner-gl", "umbral-unpack"};

/// The programs and libraries of Umbral itself: whatever was built anew may judge or draw otherwise.
void add_installation(Sha256& hash, const Toolchain& tools)
{
    for (const char* const program : programs) add_file(hash, tools.programs / program);
    add_folder(hash, tools.programs.parent_path() / "lib");
    add_file(hash, tools.student_header.string() + ".gch");
    add_file(hash, tools.units / "framework-exports.txt");
    hash.update_field(tools.compiler);
    hash.update(std::uint64_t{tools.flags.size()});
    for (const std::string& flag : tools.flags) hash.update_field(flag);
}

void add_fingerprint(Sha256& hash, const Fingerprint& fingerprint)
{
    for (const std::string* const field :
         {&fingerprint.version, &fingerprint.commit, &fingerprint.cpu, &fingerprint.compiler, &fingerprint.libm})
        hash.update_field(*field);
    hash.update(std::uint64_t{fingerprint.protections.size()});
    for (const std::string& protection : fingerprint.protections) hash.update_field(protection);
}

void add_unit(Sha256& hash, const Toolchain& tools, const Exercise& exercise)
{
    hash.update_field(exercise.id);
    hash.update_field(exercise.digest);
    add_folder(hash, unit_folder(tools, exercise.id));
    for (const std::string& used : exercise.uses) add_folder(hash, unit_folder(tools, used));
    for (const char* const candidates : {"mistakes", "alternatives"}) add_folder(hash, exercise.folder / candidates);
    add_file(hash, exercise.folder / packaged_file);
    for (const auto& [name, text] : reference_shaders(tools, exercise)) {
        hash.update_field(name);
        hash.update_field(text);
    }
}

}

std::string machine_digest(const Fingerprint& fingerprint)
{
    Sha256 hash;
    hash.update_field("umbral-machine-1");
    add_fingerprint(hash, fingerprint);
    return hash.finish();
}

UnitKeys::UnitKeys(const Toolchain& tools, const std::vector<Exercise>& exercises, const KeyPlan& plan)
{
    Sha256 common;
    common.update_field("umbral-installation-1");
    add_installation(common, tools);
    add_fingerprint(common, plan.fingerprint);
    common.update(std::uint64_t{plan.instructor_edition});
    reports_ = common.finish();
    for (const Exercise& exercise : exercises) {
        Sha256 hash;
        hash.update_field("umbral-unit-key-1");
        hash.update_field(reports_);
        hash.update_field(exercise.gl ? plan.fingerprint.gl : "");
        for (const std::string* const field : {&plan.grading.secret, &plan.grading.course}) hash.update_field(*field);
        hash.update(std::uint64_t{plan.grading.attempt});
        hash.update(std::uint64_t{plan.explain});
        add_unit(hash, tools, exercise);
        by_unit_[exercise.id] = hash.finish();
    }
}

std::string UnitKeys::key(const Exercise& exercise, const std::string& student, const Handed& handed) const
{
    Sha256 hash;
    hash.update_field(by_unit_.at(exercise.id));
    hash.update_field(student);
    hash.update(std::uint64_t{handed.files.size()});
    for (const auto& [name, text] : handed.files) {
        hash.update_field(name);
        hash.update_field(text);
    }
    for (const auto* const list : {&handed.missing, &handed.notes}) {
        hash.update(std::uint64_t{list->size()});
        for (const std::string& line : *list) hash.update_field(line);
    }
    hash.update_field(handed.refused);
    return hash.finish();
}

}
