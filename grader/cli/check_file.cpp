#include "cli/check_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "build/builder.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "report/paint.hpp"
#include "unit/own_file.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

constexpr int label_width = 14;
constexpr std::size_t most_shown = 240;  ///< letters of a text from a run

/// The student's library. Throws UsageError with what the compiler said.
Built build_handed(const Application& application, const Exercise& exercise, const fs::path& folder)
{
    const Handed handed = collect(read_submission(folder, {&exercise, 1}, archive_tools(application.tools)), exercise);
    if (!handed.refused.empty()) throw UsageError(fmt::format("not read in {}: {}", folder.string(), handed.refused));
    if (!handed.missing.empty())
        throw UsageError(fmt::format("not found in {}: {}", folder.string(), fmt::join(handed.missing, ", ")));
    have_built(application, {&exercise, 1});
    Built built = build(application.tools, exercise, handed.files);
    if (built.verdict != Verdict::ok) throw UsageError(fmt::format("{}:\n{}", in_words(built.verdict), built.message));
    return built;
}

void print_line(const Paint& paint, const std::string& label, const std::string& text)
{
    if (text.empty()) return;
    const std::string cut = text.size() > most_shown ? text.substr(0, most_shown) + " …" : text;
    fmt::print("    {:<{}}{}\n", paint.safe(label), label_width, paint.safe(cut));
}

/// What kept the student's run from its end; empty if nothing did.
std::string trouble_of(const RunOutcome& run)
{
    if (run.verdict != Verdict::ok) return fmt::format("{}: {}", in_words(run.verdict), run.message);
    return run.recording.not_implemented > 0 ? std::string(in_words(Verdict::not_implemented)) : "";
}

}

int check_file(const Application& application, const Exercise& exercise, const fs::path& folder, const fs::path& file)
{
    const std::string bytes = read_given("--file", file, most_own_file_bytes);
    const Built built = build_handed(application, exercise, folder);
    Worker worker(application.tools);
    FileReadings readings;
    try {
        readings = read_own_file(worker, exercise, built, bytes);
    } catch (const ReadsNoFiles& error) {
        throw UsageError(fmt::format("{}; --file is for units that do, such as meshes/ply", error.what()));
    }
    const Paint paint(application.style);
    fmt::print("  {} reads {}, {} bytes\n", exercise.id, paint.safe(file.filename().string()), bytes.size());
    const std::string trouble = trouble_of(readings.student);
    bool same = trouble.empty();
    for (const FileValue& value : compare_readings(readings.student.recording, readings.reference.recording)) {
        if (trouble.empty() && value.same) {
            print_line(paint, value.name, value.expected + ", both");
            continue;
        }
        same = false;
        if (trouble.empty() && value.yours != value.expected) print_line(paint, value.name, "yours " + value.yours);
        print_line(paint, trouble.empty() && value.yours != value.expected ? "" : value.name,
                   "expected " + value.expected);
        if (trouble.empty()) print_line(paint, "", value.first.empty() ? "" : "first differs in " + value.first);
    }
    print_line(paint, "yours", trouble.empty() ? message_of(readings.student.recording) : trouble);
    print_line(paint, "reference", message_of(readings.reference.recording));
    fmt::print("  {}\n", same ? "Your reading is the reference's." : "Your reading is not the reference's.");
    return same ? exit_ok : exit_not_right;
}

}
