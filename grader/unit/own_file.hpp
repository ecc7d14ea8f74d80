#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "worker/worker.hpp"

namespace umbral::grader {

/// The case in which a driver reads a file that the student gives: `Case::source(own_file_case)` holds its bytes. Units
/// that have none read no files.
///
/// What the case records is compared value by value: tables row by row, texts as they are. A text called "message" is
/// only shown. No check looks at this case: it earns nothing.
inline constexpr const char* own_file_case = "own file";

/// Bytes of such a file.
inline constexpr std::size_t most_own_file_bytes = std::size_t{16} << 20U;

/// The unit's driver has no case for files.
class ReadsNoFiles : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What two solutions made of one file.
struct FileReadings {
    RunOutcome student;
    RunOutcome reference;
};

/// Lets a student's build and the reference read the same bytes, each in a sandboxed run. However hostile they are, a
/// run that they lead astray ends alone. Throws ReadsNoFiles, and std::runtime_error for faults of the grader's.
[[nodiscard]] FileReadings read_own_file(Worker& worker, const Exercise& exercise, const Built& built,
                                         const std::string& bytes);

/// One recorded value of both.
struct FileValue {
    std::string name;
    std::string yours;     ///< a short text, a number, or "1,024 rows"
    std::string expected;  ///< likewise
    std::string first;     ///< of tables that differ: where first, and what stands there; empty if they do not differ
    bool same = true;
};

/// All values that the reference recorded, texts first, then what holds one number, then tables, each by name. A NaN
/// equals a NaN, and 0 equals -0. Believes nothing of the student's recording but what parse_recording has checked.
[[nodiscard]] std::vector<FileValue> compare_readings(const Recording& student, const Recording& reference);

/// What a run says in its text "message"; empty if it says nothing.
[[nodiscard]] std::string message_of(const Recording& recording);

}
