#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace umbral::grader {

/// How much of what a submission contains or produces the grader takes in, keeps and shows. One place for all of them:
/// whatever a submission does, a report of a unit stays below a few megabytes, and grading it below a known time and
/// memory.
namespace caps {

inline constexpr std::size_t message = std::size_t{8}
                                       << 10U;  ///< bytes of a text that says what happened: diagnostics, an exception
inline constexpr std::size_t name = 256;        ///< bytes of one name: a function, a file, a system call
inline constexpr std::size_t symbol = 4096;     ///< bytes of a name as the linker knows it
inline constexpr std::size_t listed = 12;       ///< entries of a list that is shown; the rest is counted
inline constexpr std::size_t printed = std::size_t{16} << 10U;  ///< bytes that a unit's cases printed, together
inline constexpr std::size_t unit_sources = std::size_t{2}
                                            << 20U;  ///< bytes of the files that are taken of one unit, together
inline constexpr std::size_t preprocessed = std::size_t{32}
                                            << 20U;            ///< bytes of a unit's files with all that they include
inline constexpr std::size_t library = std::size_t{8} << 20U;  ///< bytes of a compiled unit
inline constexpr std::size_t build_folder =
    std::size_t{96} << 20U;                   ///< bytes that building a unit may leave on the disk while it lasts
inline constexpr double compile_seconds = 5;  ///< of processor time, for compiling a unit; a usual one takes a half …
inline constexpr double shared_compile_seconds = 60;  ///< … and so many more for all units of a submission together
/// Of a student's code in all its runs, also those that look for why it is wrong; a usual unit takes a half …
inline constexpr double run_seconds = 6;
inline constexpr double shared_run_seconds = 240;      ///< … and so many more for all units of a submission together
inline constexpr std::size_t inspected_names = 20000;  ///< names of one kind that are read from a compiled unit
inline constexpr std::size_t rows_factor = 4;  ///< rows of a table that are judged: this many times the expected ones …
inline constexpr std::size_t rows_more = 1024;  ///< … and so many more, so that "too many" can still be shown
inline constexpr std::size_t trace_bytes = std::size_t{8}
                                           << 20U;  ///< the same for a trace of OpenGL calls, which is text
/// Cases of a unit that may use up their time or memory; the rest is not reached.
inline constexpr int endless_cases = 2;
inline constexpr double unit_limits = 3;  ///< times what one may take: all cases of a unit, each time that they run

// What is read of a submission before units are chosen from it.
inline constexpr std::size_t source_file = std::size_t{512} << 10U;  ///< bytes of one file of source code
inline constexpr std::size_t unit_files = 32;                        ///< files that are taken of one unit
inline constexpr std::size_t submission_entries = 50'000;            ///< names looked at, in all folders and archives
inline constexpr std::size_t submission_depth = 64;                  ///< folders within folders
inline constexpr std::size_t submission_files = 4096;                ///< files of source code that are read
inline constexpr std::size_t submission_bytes = std::size_t{32} << 20U;  ///< of these, together
inline constexpr std::size_t submission_ignored = 256;                   ///< entries in the list of what was not read
inline constexpr std::size_t submission_archives = 8;  ///< archives that are opened, those within others too
inline constexpr std::size_t archive_depth = 2;        ///< an archive, and one within it
inline constexpr std::size_t archive_file = std::size_t{64} << 20U;  ///< bytes of an archive as it was handed in
inline constexpr std::size_t archive_unpacked = std::size_t{256}
                                                << 20U;  ///< bytes to which an archive is unpacked before that stops
inline constexpr std::size_t archive_path = 4096;        ///< bytes of a path in an archive
inline constexpr std::size_t file_name = 255;            ///< of its last part: file systems take no longer ones
inline constexpr double unpack_seconds = 10;             ///< of processor time, for unpacking an archive …
inline constexpr double all_unpack_seconds = 20;         ///< … and for all archives of a submission together

}

/// Text of foreign origin made fit to print and store, and no longer than `limit` bytes: see printable(). Short enough
/// for one line: line feeds become spaces, and what is cut is marked by "…".
[[nodiscard]] std::string one_line(std::string_view text, std::size_t limit = caps::name);

/// "a, b, c and 14 more": at most caps::listed of `names`, each as one_line().
[[nodiscard]] std::string listed(std::span<const std::string> names);

}
