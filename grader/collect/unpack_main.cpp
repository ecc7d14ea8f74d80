#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "collect/archive.hpp"
#include "collect/file_names.hpp"
#include "model/caps.hpp"

// umbral-unpack ARCHIVE
// Reads a hostile archive in a process that may write nothing of worth. Prints records, each a word, two lengths in
// bytes, a line feed and two texts, and "end" with a line feed when all was read:
//   file PATH_BYTES DATA_BYTES     source code, or an archive within
//   ignored PATH_BYTES DATA_BYTES  what of these was not read, and why
//   note 0 DATA_BYTES              why not all could be read
namespace umbral::grader {
namespace {

struct Close {
    void operator()(archive* open) const { archive_read_free(open); }
};
using Reader = std::unique_ptr<archive, Close>;

void print(const char* word, std::string_view first, std::string_view second)
{
    (void)std::printf("%s %zu %zu\n", word, first.size(), second.size());
    (void)std::fwrite(first.data(), 1, first.size(), stdout);
    (void)std::fwrite(second.data(), 1, second.size(), stdout);
}

/// What may still be printed and unpacked.
struct Budget {
    std::size_t entries = caps::submission_entries;
    std::size_t files = caps::submission_files;
    std::size_t ignored = caps::submission_ignored;
    std::size_t code_bytes = caps::submission_bytes;
    std::size_t archive_bytes = caps::archive_file;
    std::size_t unpacked = caps::archive_unpacked;

    [[nodiscard]] bool take(std::size_t Budget::*what, std::size_t amount)
    {
        const bool enough = this->*what >= amount;
        this->*what -= enough ? amount : this->*what;
        return enough;
    }
};

struct Data {
    std::string bytes;
    bool whole = true;  ///< false: more than the limit
    bool damaged = false;
};

/// Reads at most `limit` bytes of the current entry.
Data read_data(archive* reader, std::size_t limit, Budget& budget)
{
    Data data;
    std::vector<char> block(std::size_t{64} << 10U);
    while (data.whole) {
        const la_ssize_t got = archive_read_data(reader, block.data(), block.size());
        if (got == 0) break;
        if (got < 0) data.damaged = true;
        if (got < 0 || !budget.take(&Budget::unpacked, static_cast<std::size_t>(got))) break;
        data.bytes.append(block.data(), static_cast<std::size_t>(got));
        data.whole = data.bytes.size() <= limit;
    }
    return data;
}

/// Passes over the current entry's data, as far as the budget goes: in a compressed stream, and in a 7z, they are
/// unpacked all the same.
void pass_over(archive* reader, Budget& budget)
{
    if (archive_filter_count(reader) <= 1 && archive_format(reader) != ARCHIVE_FORMAT_7ZIP)
        return (void)archive_read_data_skip(reader);
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    while (budget.unpacked > 0 && archive_read_data_block(reader, &block, &size, &offset) == ARCHIVE_OK)
        (void)budget.take(&Budget::unpacked, size);
}

bool has_junk(std::string_view path)
{
    for (std::string_view rest = path; !rest.empty(); rest = parent_part(rest))
        if (is_junk(last_part(rest)) || is_framework_copy(rest)) return true;
    return false;
}

/// Could no folder hold a file of this path?
bool is_too_long(std::string_view path)
{
    return path.size() > caps::archive_path || last_part(path).size() > caps::file_name;
}

std::string path_of(archive_entry* entry)
{
    const char* path = archive_entry_pathname(entry);
    if (path == nullptr) path = archive_entry_pathname_utf8(entry);
    return path == nullptr ? std::string() : harmless_path(path);
}

/// Why the current entry is not read; empty if it is, and then its bytes are in `data`.
std::string read_entry(archive* reader, archive_entry* entry, FileKind kind, Budget& budget, Data& data)
{
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr)
        return "it is not a regular file: hand in the file itself";
    if (archive_entry_is_encrypted(entry) != 0) return "it is encrypted: hand it in without a password";
    const std::size_t limit = kind == FileKind::archive ? caps::archive_file : caps::source_file;
    data = read_data(reader, limit, budget);
    if (!data.whole) return "it has too many bytes; at most " + std::to_string(limit) + " are read";
    if (data.damaged) return "it is damaged";
    const auto share = kind == FileKind::archive ? &Budget::archive_bytes : &Budget::code_bytes;
    if (!budget.take(&Budget::files, 1) || !budget.take(share, data.bytes.size())) return "the archive holds too much";
    return "";
}

/// Prints all entries of worth; says why it stopped, if not at the end.
std::string print_entries(archive* reader)
{
    Budget budget;
    archive_entry* entry = nullptr;
    for (;;) {
        const int status = archive_read_next_header(reader, &entry);
        if (status == ARCHIVE_EOF) return "";
        if (status < ARCHIVE_WARN) {
            const char* reason = archive_error_string(reader);
            return std::string("it is damaged: ") + (reason == nullptr ? "no reason given" : reason);
        }
        if (!budget.take(&Budget::entries, 1)) return "it has too many entries; the rest is not read";
        const std::string path = path_of(entry);
        if (path.empty() && archive_entry_filetype(entry) == AE_IFREG && budget.take(&Budget::ignored, 1))
            print("ignored", "?", "its name cannot be read: rename the file and pack it again");
        const FileKind kind = kind_of(last_part(path));
        const bool of_worth = (is_code(kind) || kind == FileKind::archive) && !is_too_long(path) && !has_junk(path);
        if (of_worth && archive_entry_filetype(entry) != AE_IFDIR) {
            Data data;
            const std::string objection = read_entry(reader, entry, kind, budget, data);
            if (objection.empty())
                print("file", path, data.bytes);
            else if (budget.take(&Budget::ignored, 1))
                print("ignored", path, objection);
        }
        pass_over(reader, budget);
        if (budget.unpacked == 0) return "it unpacks to too many bytes; the rest is not read";
    }
}

std::string read_archive(const char* path)
{
    const Reader reader(archive_read_new());
    if (!reader) return "no memory";
    archive_read_support_filter_gzip(reader.get());
    archive_read_support_filter_bzip2(reader.get());
    archive_read_support_filter_xz(reader.get());
    archive_read_support_format_tar(reader.get());
    archive_read_support_format_zip(reader.get());
    archive_read_support_format_7zip(reader.get());
    if (archive_read_open_filename(reader.get(), path, std::size_t{64} << 10U) != ARCHIVE_OK)
        return "it is no archive that can be opened: hand in a zip, a tar.gz or a folder";
    return print_entries(reader.get());
}

}
}

int main(int count, char** words)
{
    if (count != 2) return (void)std::fputs("usage: umbral-unpack ARCHIVE\n", stderr), 2;
    // Names in archives are converted by the locale: without it, those beyond ASCII are lost.
    (void)std::setlocale(LC_ALL, "C.UTF-8");
    const std::string reason = umbral::grader::read_archive(words[1]);
    if (!reason.empty()) umbral::grader::print("note", "", reason.substr(0, umbral::grader::caps::message));
    (void)std::printf("end\n");
    return std::fflush(stdout) == 0 ? 0 : 1;
}
