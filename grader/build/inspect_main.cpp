#include <cxxabi.h>
#include <elfutils/libdw.h>
#include <dwarf.h>
#include <fcntl.h>
#include <gelf.h>
#include <libelf.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

// umbral-inspect names FILE: its dynamic symbols and the functions that left code in it, as JSON.
// umbral-inspect lines FILE ADDRESS…: the first address that a file without a directory produced, as "sphere.cpp:17".
// It reads files made by hostile sources, so it runs in umbral-confine and holds nothing worth stealing.
namespace {

using Names = std::set<std::string>;

std::string demangled(const char* name)
{
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(abi::__cxa_demangle(name, nullptr, nullptr, &status), &std::free);
    return status == 0 ? std::string(text.get()) : std::string(name);
}

void add_symbols(Elf* elf, Names& exported, Names& undefined)
{
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(section, &header) == nullptr || header.sh_type != SHT_DYNSYM || header.sh_entsize == 0) continue;
        Elf_Data* data = elf_getdata(section, nullptr);
        const auto count = static_cast<int>(header.sh_size / header.sh_entsize);
        for (int i = 1; data != nullptr && i < count; ++i) {
            GElf_Sym symbol;
            const char* name = nullptr;
            if (gelf_getsym(data, i, &symbol) == nullptr || (name = elf_strptr(elf, header.sh_link, symbol.st_name)) == nullptr) continue;
            const auto binding = GELF_ST_BIND(symbol.st_info);
            if (symbol.st_shndx == SHN_UNDEF) {
                if (binding != STB_WEAK || std::string_view(name).starts_with("_Z")) undefined.insert(name);
            } else if (binding != STB_LOCAL) {
                exported.insert(name);
            }
        }
    }
}

/// The name of a subprogram that left code: it has an address, or a copy of it was inlined somewhere.
void add_function(Dwarf_Die* die, Names& functions)
{
    Dwarf_Attribute attribute;
    if (dwarf_hasattr(die, DW_AT_low_pc) == 0 && dwarf_hasattr(die, DW_AT_inline) == 0) return;
    for (const unsigned kind : {DW_AT_linkage_name, DW_AT_MIPS_linkage_name, DW_AT_name}) {
        if (dwarf_attr_integrate(die, kind, &attribute) == nullptr) continue;
        if (const char* name = dwarf_formstring(&attribute)) functions.insert(demangled(name));
        return;
    }
}

// Depth is bounded, since a forged tree could be as deep as its file is long.
void walk(Dwarf_Die* parent, int depth, Names& functions)
{
    Dwarf_Die die;
    if (depth > 64 || dwarf_child(parent, &die) != 0) return;
    do {
        const int tag = dwarf_tag(&die);
        if (tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine) add_function(&die, functions);
        if (tag == DW_TAG_namespace || tag == DW_TAG_subprogram || tag == DW_TAG_structure_type || tag == DW_TAG_class_type || tag == DW_TAG_lexical_block)
            walk(&die, depth + 1, functions);
    } while (dwarf_siblingof(&die, &die) == 0);
}

template <class Visit>
void for_each_unit(Dwarf* dwarf, Visit visit)
{
    Dwarf_CU* unit = nullptr;
    Dwarf_Die die;
    while (dwarf_get_units(dwarf, unit, &unit, nullptr, nullptr, &die, nullptr) == 0)
        if (visit(&die)) return;
}

int print_names(Elf* elf, Dwarf* dwarf)
{
    Names exported;
    Names undefined;
    Names functions;
    add_symbols(elf, exported, undefined);
    for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        walk(unit, 0, functions);
        return false;
    });
    const nlohmann::json json = {{"exported", exported}, {"undefined", undefined}, {"functions", functions}};
    std::puts(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return 0;
}

/// Prints where `address` comes from, if that is a file of the student's own: those are compiled by their bare names.
bool print_line(Dwarf* dwarf, Dwarf_Addr address)
{
    bool found = false;
    for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        Dwarf_Line* line = dwarf_getsrc_die(unit, address);
        int number = 0;
        const char* file = line == nullptr ? nullptr : dwarf_linesrc(line, nullptr, nullptr);
        if (file == nullptr || dwarf_lineno(line, &number) != 0) return false;
        const std::string_view path(file);
        const std::size_t slash = path.rfind('/');
        if (path.starts_with("/usr/") || path.find("/umbral/") != std::string_view::npos) return false;
        const std::string name(slash == std::string_view::npos ? path : path.substr(slash + 1));
        std::printf("%s:%d\n", name.c_str(), number);
        return found = true;
    });
    return found;
}

}

int main(int count, char** words)
{
    if (count < 3) {
        (void)std::fputs("usage: umbral-inspect names FILE | lines FILE ADDRESS…\n", stderr);
        return 2;
    }
    elf_version(EV_CURRENT);
    const int file = open(words[2], O_RDONLY | O_CLOEXEC);
    Elf* elf = file < 0 ? nullptr : elf_begin(file, ELF_C_READ_MMAP, nullptr);
    Dwarf* dwarf = elf == nullptr ? nullptr : dwarf_begin_elf(elf, DWARF_C_READ, nullptr);
    if (dwarf == nullptr) {
        (void)std::fprintf(stderr, "%s: no ELF file with debug information\n", words[2]);
        return 1;
    }
    if (std::strcmp(words[1], "names") == 0) return print_names(elf, dwarf);
    for (int i = 3; i < count; ++i) {
        const Dwarf_Addr address = std::strtoull(words[i], nullptr, 10);
        // A return address is behind its call: one byte before it lies in the line that called.
        if (print_line(dwarf, i == 3 ? address : address - 1)) break;
    }
    return 0;
}
