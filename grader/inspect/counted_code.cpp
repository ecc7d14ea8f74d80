#include "inspect/counted_code.hpp"

#include <gelf.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "inspect/demangle.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

using Bytes = std::span<const unsigned char>;

/// Bytes before the first function of .text that the C runtime may take (four functions, 0xba bytes with g++ 12), and
/// between two functions, where linkers pad.
constexpr std::uint64_t runtime_code = 192;
constexpr std::uint64_t padding = 32;

struct Section {
    std::string_view name;
    GElf_Shdr header{};
    Bytes bytes;
};

/// From where to where in memory a function lies.
struct CodeRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

std::vector<Section> sections_of(Elf* elf)
{
    std::vector<Section> sections;
    std::size_t names = 0;
    if (elf_getshdrstrndx(elf, &names) != 0) return sections;
    for (Elf_Scn* place = nullptr; (place = elf_nextscn(elf, place)) != nullptr;) {
        Section section;
        if (gelf_getshdr(place, &section.header) == nullptr) continue;
        if (const char* name = elf_strptr(elf, names, section.header.sh_name)) section.name = name;
        const Elf_Data* data = elf_rawdata(place, nullptr);
        if (data != nullptr && data->d_buf != nullptr)
            section.bytes = {static_cast<const unsigned char*>(data->d_buf), data->d_size};
        sections.push_back(section);
    }
    return sections;
}

std::int32_t number_at(Bytes bytes, std::size_t offset)
{
    std::int32_t number = 0;
    if (offset + sizeof number <= bytes.size()) std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

/// The functions that .eh_frame lists, in order of their addresses. Nothing if an entry is none as g++ writes them: of
/// 32 bits, with addresses relative to where they stand.
std::optional<std::vector<CodeRange>> code_ranges_in(const Section& frames)
{
    constexpr std::size_t length_size = 4;
    constexpr std::size_t head = 16;  // length, distance to the common entry, begin, size
    std::vector<CodeRange> functions;
    for (std::size_t at = 0; at + length_size <= frames.bytes.size();) {
        const auto length = static_cast<std::uint32_t>(number_at(frames.bytes, at));
        if (length == 0) break;
        if (length > frames.bytes.size() - at - length_size) return std::nullopt;
        if (number_at(frames.bytes, at + 4) == 0) {
            // Version 1, then the augmentation: "zR", "zPLR" and the like, where R says that addresses are encoded.
            if (length < 12 || frames.bytes[at + 8] != 1 || frames.bytes[at + 9] != 'z') return std::nullopt;
        } else {
            if (length + length_size < head) return std::nullopt;
            const std::uint64_t place = frames.header.sh_addr + at + 8;
            const std::uint64_t begin =
                place + static_cast<std::uint64_t>(std::int64_t{number_at(frames.bytes, at + 8)});
            const auto size = static_cast<std::uint32_t>(number_at(frames.bytes, at + 12));
            if (size > 0) functions.push_back({begin, begin + size});
        }
        at += length_size + length;
    }
    std::ranges::sort(functions, {}, &CodeRange::begin);
    return functions;
}

/// Where the counter stands in the table of addresses that the loader fills; `other_uses` is set if anything else wants
/// its address.
std::optional<std::uint64_t> counter_slot(Elf* elf, bool& other_uses)
{
    std::optional<std::uint64_t> slot;
    for (Elf_Scn* place = nullptr; (place = elf_nextscn(elf, place)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(place, &header) == nullptr || header.sh_type != SHT_RELA || header.sh_entsize == 0) continue;
        Elf_Data* relocations = elf_getdata(place, nullptr);
        Elf_Scn* symbols_place = elf_getscn(elf, header.sh_link);
        GElf_Shdr symbols_header;
        Elf_Data* symbols = symbols_place == nullptr ? nullptr : elf_getdata(symbols_place, nullptr);
        if (relocations == nullptr || symbols == nullptr || gelf_getshdr(symbols_place, &symbols_header) == nullptr)
            continue;
        for (std::size_t index = 0; index < header.sh_size / header.sh_entsize; ++index) {
            GElf_Rela relocation;
            GElf_Sym symbol;
            if (gelf_getrela(relocations, static_cast<int>(index), &relocation) == nullptr) break;
            if (gelf_getsym(symbols, static_cast<int>(GELF_R_SYM(relocation.r_info)), &symbol) == nullptr) continue;
            const char* name = elf_strptr(elf, symbols_header.sh_link, symbol.st_name);
            if (name == nullptr || std::string_view(name) != block_counter) continue;
            const bool call = GELF_R_TYPE(relocation.r_info) == R_X86_64_JUMP_SLOT && symbol.st_shndx == SHN_UNDEF;
            if (!call || slot) other_uses = true;
            if (call) slot = relocation.r_offset;
        }
    }
    return slot;
}

/// The bytes that lie at an address of the file's code.
Bytes code_at(const std::vector<Section>& sections, std::uint64_t begin, std::uint64_t end)
{
    for (const Section& section : sections) {
        const std::uint64_t start = section.header.sh_addr;
        if ((section.header.sh_flags & SHF_EXECINSTR) == 0 || begin < start || end < begin ||
            end - start > section.bytes.size())
            continue;
        return section.bytes.subspan(begin - start, end - begin);
    }
    return {};
}

/// Does an entry of the linker's table of jumps begin at `target`, and lead through `slot`? It is `jmp *slot(%rip)`,
/// after two instructions at most.
bool leads_to(const std::vector<Section>& sections, std::uint64_t target, std::uint64_t slot)
{
    constexpr std::size_t entry = 16;
    const Bytes code = code_at(sections, target, target + entry);
    for (std::size_t i = 0; i + 6 <= code.size(); ++i)
        if (code[i] == 0xff && code[i + 1] == 0x25)
            return target + i + 6 + static_cast<std::uint64_t>(std::int64_t{number_at(code, i + 2)}) == slot;
    return false;
}

bool calls(const std::vector<Section>& sections, const CodeRange& function, std::uint64_t slot)
{
    const Bytes code = code_at(sections, function.begin, function.end);
    for (std::size_t i = 0; i + 5 <= code.size(); ++i) {
        const std::uint64_t target =
            function.begin + i + 5 + static_cast<std::uint64_t>(std::int64_t{number_at(code, i + 1)});
        if (code[i] == 0xe8 && leads_to(sections, target, slot)) return true;
    }
    return false;
}

/// What .symtab calls the function at an address.
std::string name_at(Elf* elf, std::uint64_t address)
{
    for (Elf_Scn* place = nullptr; (place = elf_nextscn(elf, place)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(place, &header) == nullptr || header.sh_type != SHT_SYMTAB || header.sh_entsize == 0) continue;
        Elf_Data* data = elf_getdata(place, nullptr);
        for (std::size_t i = 1; data != nullptr && i < header.sh_size / header.sh_entsize; ++i) {
            GElf_Sym symbol;
            if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) break;
            if (symbol.st_value != address || GELF_ST_TYPE(symbol.st_info) != STT_FUNC) continue;
            if (const char* name = elf_strptr(elf, header.sh_link, symbol.st_name)) return demangled(name, caps::name);
        }
    }
    return "a function without a name";
}

/// Does the library define what the linker calls in place of a counted function of the C library?
bool counts_calls_itself(Elf* elf)
{
    for (Elf_Scn* place = nullptr; (place = elf_nextscn(elf, place)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(place, &header) == nullptr || header.sh_entsize == 0) continue;
        if (header.sh_type != SHT_SYMTAB && header.sh_type != SHT_DYNSYM) continue;
        Elf_Data* data = elf_getdata(place, nullptr);
        for (std::size_t i = 1; data != nullptr && i < header.sh_size / header.sh_entsize; ++i) {
            GElf_Sym symbol;
            if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) break;
            if (symbol.st_shndx == SHN_UNDEF) continue;
            const char* name = elf_strptr(elf, header.sh_link, symbol.st_name);
            // Linkers name their jumps `__wrap_memmove$plt`.
            const std::string_view bare = name == nullptr ? "" : name;
            if (bare.starts_with("__wrap_") && bare.find('$') == std::string_view::npos) return true;
        }
    }
    return false;
}

/// What the linker makes itself, by the names that it gives: jumps, and the calls of constructors.
bool is_linkers(const Section& section)
{
    constexpr std::uint64_t most_of_a_call = 64;
    if (section.name == ".plt" || section.name == ".plt.got" || section.name == ".plt.sec") return true;
    return (section.name == ".init" || section.name == ".fini") && section.header.sh_size <= most_of_a_call;
}

/// Is there code outside all functions?
bool has_other_code(const Section& section, const std::vector<CodeRange>& functions)
{
    const std::uint64_t begin = section.header.sh_addr;
    const std::uint64_t end = begin + section.header.sh_size;
    std::uint64_t reached = begin;
    for (const CodeRange& function : functions) {
        if (function.begin < begin || function.begin >= end) continue;
        const std::uint64_t allowed = reached == begin && section.name == ".text" ? runtime_code : padding;
        if (function.begin > reached && function.begin - reached > allowed) return true;
        reached = std::max(reached, function.end);
    }
    return end > reached && end - reached > padding;
}

}

std::vector<std::string> uncounted_code(Elf* elf)
{
    const std::vector<Section> sections = sections_of(elf);
    const auto frames = std::ranges::find(sections, ".eh_frame", &Section::name);
    const auto functions = frames == sections.end() ? std::nullopt : code_ranges_in(*frames);
    if (!functions) return {"the list of functions in .eh_frame is not as the compiler writes it"};
    bool other_uses = false;
    const auto slot = counter_slot(elf, other_uses);
    if (!slot) return {std::string("no function calls ") + block_counter + " of the framework"};
    if (other_uses) return {std::string("the address of ") + block_counter + " is taken"};

    if (counts_calls_itself(elf)) return {"a function whose name begins with __wrap_, which is the framework's,"};

    std::set<std::string> reasons;
    for (const CodeRange& function : *functions)
        if (reasons.size() < caps::listed && !calls(sections, function, *slot))
            reasons.insert(name_at(elf, function.begin));
    for (const Section& section : sections)
        if ((section.header.sh_flags & SHF_EXECINSTR) != 0 && !is_linkers(section) &&
            has_other_code(section, *functions))
            reasons.insert("code outside all functions in " + std::string(section.name));
    return {reasons.begin(), reasons.end()};
}

}
