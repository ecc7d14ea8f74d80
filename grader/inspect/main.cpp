#include <elfutils/libdw.h>
#include <fcntl.h>
#include <libelf.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/names.hpp"
#include "inspect/open.hpp"
#include "inspect/places.hpp"

// umbral-inspect names FILE INTERFACE: its dynamic symbols and the functions that left code in it, as JSON; INTERFACE
// lists the names that it is to define. umbral-inspect lines FILE ADDRESS…: the first address that a file without a
// directory produced, as "sphere.cpp:17". umbral-inspect places FILE ADDRESS…: for each of these return addresses such
// a place, as "sphere.cpp:17:9", or an empty line. It reads files made by hostile sources, so it runs in umbral-confine
// and holds nothing worth stealing.
namespace {

std::vector<std::string> lines_of(const char* file)
{
    std::vector<std::string> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string text_of(const umbral::grader::OwnPlace& place, bool with_column)
{
    const std::string text = place.file + ":" + std::to_string(place.line);
    return with_column ? text + ":" + std::to_string(place.column) : text;
}

}

int main(int count, char** words)
{
    using namespace umbral::grader;
    const std::string_view what = count > 1 ? words[1] : "";
    if (!(what == "names" && count == 4) && !((what == "lines" || what == "places") && count >= 3)) {
        (void)std::fputs("usage: umbral-inspect names FILE INTERFACE | (lines | places) FILE ADDRESS…\n", stderr);
        return 2;
    }
    elf_version(EV_CURRENT);
    const int file = open(words[2], O_RDONLY | O_CLOEXEC);
    Elf* elf = file < 0 ? nullptr : elf_begin(file, ELF_C_READ_MMAP, nullptr);
    Dwarf* dwarf = elf == nullptr ? nullptr : open_debug_information(elf);
    if (dwarf == nullptr) {
        (void)std::fprintf(stderr, "%s: no ELF file with debug information\n", words[2]);
        return 1;
    }
    if (what == "names") {
        const std::string json = names_as_json(elf, dwarf, lines_of(words[3]));
        (void)std::puts(json.c_str());
        return json.empty() ? 1 : 0;
    }
    for (int i = 3; i < count; ++i) {
        const Dwarf_Addr address = std::strtoull(words[i], nullptr, 10);
        // A return address is behind its call: one byte before it lies in the line that called.
        const bool returns = what == "places" || i > 3;
        const auto place = place_in_own_files(dwarf, returns ? address - 1 : address);
        if (what == "places") {
            (void)std::puts(place ? text_of(*place, true).c_str() : "");
            continue;
        }
        if (!place) continue;
        (void)std::puts(text_of(*place, false).c_str());
        break;
    }
    return 0;
}
