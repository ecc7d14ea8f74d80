#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace umbral::test {

/// One entry of an archive to write; `type` as AE_IFREG, AE_IFLNK, AE_IFCHR, AE_IFIFO.
struct ArchiveEntry {
    std::string path;
    std::string data;
    unsigned type = AE_IFREG;
    std::string link{};
};

/// The bytes of an archive that holds `entries`: format "zip", "ustar", "pax" or "7zip", filter "none", "gzip", "xz" or
/// "bzip2".
inline std::string write_archive(const std::string& format, const std::string& filter,
                                 const std::vector<ArchiveEntry>& entries)
{
    std::string bytes;
    archive* writer = archive_write_new();
    archive_write_set_format_by_name(writer, format.c_str());
    if (filter != "none") archive_write_add_filter_by_name(writer, filter.c_str());
    const auto append = [](archive*, void* to, const void* data, std::size_t size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
        return static_cast<la_ssize_t>(size);
    };
    archive_write_set_bytes_in_last_block(writer, 1);
    const auto check = [&](int status) {
        if (status < ARCHIVE_WARN) throw std::runtime_error(archive_error_string(writer));
    };
    check(archive_write_open(writer, &bytes, nullptr, append, nullptr));
    for (const ArchiveEntry& one : entries) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, one.path.c_str());
        archive_entry_set_filetype(entry, one.type);
        archive_entry_set_perm(entry, 0644);
        if (one.type == AE_IFLNK) archive_entry_set_symlink(entry, one.link.c_str());
        archive_entry_set_size(entry, one.type == AE_IFREG ? static_cast<la_int64_t>(one.data.size()) : 0);
        check(archive_write_header(writer, entry));
        if (one.type == AE_IFREG && archive_write_data(writer, one.data.data(), one.data.size()) < 0)
            throw std::runtime_error(archive_error_string(writer));
        archive_entry_free(entry);
    }
    check(archive_write_close(writer));
    archive_write_free(writer);
    return bytes;
}

}
