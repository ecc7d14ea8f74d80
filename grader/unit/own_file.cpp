#include "unit/own_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/rows/tensor_view.hpp"
#include "worker/packaged_unit.hpp"
#include "worker/run_roots.hpp"

namespace umbral::grader {
namespace {

constexpr const char* message_name = "message";
/// A real model takes longer than a unit's small ones.
constexpr Limits file_limits{.wall_seconds = 30, .memory_mib = 2048};

RunRequest request_of(const Toolchain& tools, const Exercise& exercise, const std::string& bytes)
{
    RunRequest request;
    request.driver = unit_folder(tools, exercise.id) / "driver.so";
    request.case_name = own_file_case;
    request.sources.emplace(own_file_case, bytes);
    request.limits = file_limits;
    request.roots = run_roots(tools);
    request.roots.push_back(request.driver.parent_path().string());
    return request;
}

bool is_text(const Tensor& tensor) { return tensor.element == Element::uint8; }

bool same_row(const TensorView& one, const TensorView& other, std::size_t row)
{
    return one.components() == other.components() && one.present(row) == other.present(row) &&
           std::ranges::equal(one.cell(row), other.cell(row), equal_or_both_nan);
}

std::string rows_text(std::size_t rows)
{
    return fmt::format("{} row{}", count_text(static_cast<double>(rows)), rows == 1 ? "" : "s");
}

/// Where two tables first differ, which is the end of the shorter one if nothing before it does.
std::string first_difference(const TensorView& yours, const TensorView& expected)
{
    const std::size_t both = std::min(yours.cells(), expected.cells());
    for (std::size_t row = 0; row < both; ++row) {
        if (same_row(yours, expected, row)) continue;
        const auto [one, other] = telling_apart([&](int digits) {
            return std::pair{cell_text(yours, row, digits), cell_text(expected, row, digits)};
        });
        return fmt::format("row {}: yours {}, expected {}", row, one, other);
    }
    if (yours.cells() == expected.cells()) return "";
    return fmt::format("row {}: {}", both, yours.cells() < expected.cells() ? "yours end here" : "yours go on");
}

FileValue compared(const std::string& name, const Tensor& yours, const Tensor& expected)
{
    FileValue value;
    value.name = name;
    if (is_text(expected)) {
        value.yours = text_of(&yours);
        value.expected = text_of(&expected);
        value.same = value.yours == value.expected;
        return value;
    }
    const TensorView one(yours);
    const TensorView other(expected);
    if (one.cells() == 1 && other.cells() == 1) {
        const auto is_count = [](const TensorView& view) {
            if (view.components() != 1 || !view.present(0)) return false;
            const double number = view.cell(0).front();
            return number >= 0 && number < 0x1p53 && number == std::floor(number);
        };
        if (is_count(one) && is_count(other)) {
            value.yours = count_text(one.cell(0).front());
            value.expected = count_text(other.cell(0).front());
            value.same = value.yours == value.expected;
            return value;
        }
        std::tie(value.yours, value.expected) = telling_apart([&](int digits) {
            return std::pair{cell_text(one, 0, digits), cell_text(other, 0, digits)};
        });
        value.same = same_row(one, other, 0);
        return value;
    }
    value.yours = rows_text(one.cells());
    value.expected = rows_text(other.cells());
    value.first = first_difference(one, other);
    value.same = value.first.empty();
    return value;
}

/// 0 texts, 1 single numbers, 2 tables.
int rank_of(const Tensor& tensor) { return is_text(tensor) ? 0 : tensor.cells() == 1 ? 1 : 2; }

}

FileReadings read_own_file(Worker& worker, const Exercise& exercise, const Built& built, const std::string& bytes)
{
    RunRequest request = request_of(worker.tools(), exercise, bytes);
    const ScratchFolder unveiled(worker.tools().cache);
    request.solution = answer_library(worker.tools(), exercise, "reference", unveiled.path());
    FileReadings readings;
    readings.reference = worker.spawner(exercise.gl).run(request);
    if (readings.reference.message.find("the driver has no case") != std::string::npos)
        throw ReadsNoFiles(exercise.id + " reads no files");
    if (readings.reference.verdict != Verdict::ok)
        throw std::runtime_error(fmt::format("{}: the reference did not finish reading the file ({}): {}", exercise.id,
                                             to_string(readings.reference.verdict), readings.reference.message));
    request.solution = built.library;
    request.mutant = built.mutant;
    request.roots.push_back(built.library.parent_path().string());
    readings.student = worker.spawner(exercise.gl).run(request);
    return readings;
}

std::vector<FileValue> compare_readings(const Recording& student, const Recording& reference)
{
    std::vector<std::pair<int, FileValue>> ranked;
    for (const auto& [name, expected] : reference.tensors) {
        if (name == message_name) continue;
        static const Tensor nothing;
        const auto found = student.tensors.find(name);
        const Tensor& yours = found == student.tensors.end() ? nothing : found->second;
        ranked.emplace_back(rank_of(expected), compared(name, yours, expected));
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<FileValue> values;
    for (auto& [rank, value] : ranked) values.push_back(std::move(value));
    return values;
}

std::string message_of(const Recording& recording)
{
    const auto found = recording.tensors.find(message_name);
    return found == recording.tensors.end() ? "" : std::string(text_of(&found->second));
}

}
