#include <dwarf.h>
#include <elfutils/libdw.h>
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

#include "build/demangle.hpp"

// umbral-inspect names FILE: its dynamic symbols and the functions that left code in it, as JSON.
// umbral-inspect lines FILE ADDRESS…: the first address that a file without a directory produced, as "sphere.cpp:17".
// It reads files made by hostile sources, so it runs in umbral-confine and holds nothing worth stealing.
namespace {

using Names = std::set<std::string>;

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
                undefined.insert(name);
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
        if (const char* name = dwarf_formstring(&attribute)) functions.insert(umbral::grader::demangled(name));
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

/// False if the debug information is damaged: what lies behind the damage was not seen.
template <class Visit>
bool for_each_unit(Dwarf* dwarf, Visit visit)
{
    Dwarf_CU* unit = nullptr;
    Dwarf_Die die;
    int end = 0;
    while ((end = dwarf_get_units(dwarf, unit, &unit, nullptr, nullptr, &die, nullptr)) == 0)
        if (visit(&die)) return true;
    return end > 0;
}

int print_names(Elf* elf, Dwarf* dwarf)
{
    Names exported;
    Names undefined;
    Names functions;
    add_symbols(elf, exported, undefined);
    const bool whole = for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        walk(unit, 0, functions);
        return false;
    });
    if (!whole || functions.empty()) return 1;
    const nlohmann::json json = {{"exported", exported}, {"undefined", undefined}, {"functions", functions}};
    std::puts(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return 0;
}

/// A file of the student's own: those lie where the compiler worked, and no other does.
bool is_own(Dwarf_Die* unit, const char* file)
{
    Dwarf_Attribute attribute;
    const char* const folder = dwarf_formstring(dwarf_attr(unit, DW_AT_comp_dir, &attribute));
    const std::string_view path(file);
    const std::size_t slash = path.rfind('/');
    if (slash == std::string_view::npos || path.substr(0, slash) == ".") return true;
    return folder != nullptr && path.substr(0, slash) == folder;
}

void print_place(const char* file, std::uint64_t line)
{
    const std::string_view path(file);
    const std::size_t slash = path.rfind('/');
    const std::string name(slash == std::string_view::npos ? path : path.substr(slash + 1));
    std::printf("%s:%llu\n", name.c_str(), static_cast<unsigned long long>(line));
}

/// Where a function that was inlined at `address`, as one of a library's header, was called by the student's own code.
bool print_call(Dwarf_Die* unit, Dwarf_Addr address)
{
    Dwarf_Die* scopes = nullptr;
    const int count = dwarf_getscopes(unit, address, &scopes);
    const std::unique_ptr<Dwarf_Die, decltype(&std::free)> owner(scopes, &std::free);
    Dwarf_Files* files = nullptr;
    if (count <= 0 || dwarf_getsrcfiles(unit, &files, nullptr) != 0) return false;
    for (int i = 0; i < count; ++i) {
        Dwarf_Attribute attribute;
        Dwarf_Word file = 0;
        Dwarf_Word line = 0;
        if (dwarf_tag(&scopes[i]) != DW_TAG_inlined_subroutine) continue;
        if (dwarf_attr(&scopes[i], DW_AT_call_file, &attribute) == nullptr || dwarf_formudata(&attribute, &file) != 0) continue;
        if (dwarf_attr(&scopes[i], DW_AT_call_line, &attribute) == nullptr || dwarf_formudata(&attribute, &line) != 0) continue;
        const char* name = dwarf_filesrc(files, file, nullptr, nullptr);
        if (name == nullptr || !is_own(unit, name)) continue;
        print_place(name, line);
        return true;
    }
    return false;
}

/// Prints where `address` comes from, if that is a file of the student's own: those are compiled by their bare names.
bool print_line(Dwarf* dwarf, Dwarf_Addr address)
{
    bool found = false;
    (void)for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        Dwarf_Line* line = dwarf_getsrc_die(unit, address);
        int number = 0;
        const char* file = line == nullptr ? nullptr : dwarf_linesrc(line, nullptr, nullptr);
        if (file == nullptr || dwarf_lineno(line, &number) != 0) return false;
        if (!is_own(unit, file)) return found = print_call(unit, address);
        print_place(file, static_cast<std::uint64_t>(number));
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
