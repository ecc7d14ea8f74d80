#include "inspect/names.hpp"

#include <dwarf.h>
#include <gelf.h>

#include <cstddef>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "inspect/counted_code.hpp"
#include "inspect/demangle.hpp"
#include "inspect/own_memory.hpp"
#include "inspect/units.hpp"
#include "model/caps.hpp"

namespace umbral::grader {
namespace {

/// A set of names that takes no more than caps::inspected_names.
template <class Item>
class Names {
public:
    void add(Item item)
    {
        if (all_.size() < caps::inspected_names)
            all_.insert(std::move(item));
        else
            overflown_ = true;
    }
    [[nodiscard]] bool overflown() const { return overflown_; }
    [[nodiscard]] const std::set<Item>& all() const { return all_; }

private:
    std::set<Item> all_;
    bool overflown_ = false;
};

/// A function as debug information describes it.
struct Function {
    std::string name;  ///< as C++ writes it
    std::string file;  ///< where it is declared, with the place of its name there
    int line = 0;
    int column = 0;
    std::string bare;  ///< without scope and arguments: what is left if a long type cuts the name before it comes

    auto operator<=>(const Function&) const = default;
};

std::string cut(const char* name, std::size_t limit) { return {name, strnlen(name, limit)}; }

struct Symbols {
    Names<std::string> defined;
    Names<std::string> undefined;
};

/// Which symbols of the table `table` the loader looks up, by their places: those of its relocations. The linker leaves
/// names in the table whose users it left out.
std::set<std::size_t> looked_up(Elf* elf, Elf_Scn* table)
{
    std::set<std::size_t> places;
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(section, &header) == nullptr || header.sh_entsize == 0 ||
            (header.sh_type != SHT_RELA && header.sh_type != SHT_REL) || header.sh_link != elf_ndxscn(table))
            continue;
        Elf_Data* data = elf_getdata(section, nullptr);
        for (std::size_t i = 0; data != nullptr && i < header.sh_size / header.sh_entsize; ++i) {
            GElf_Rela with_addend;
            GElf_Rel without;
            if (header.sh_type == SHT_RELA && gelf_getrela(data, static_cast<int>(i), &with_addend) != nullptr)
                places.insert(GELF_R_SYM(with_addend.r_info));
            else if (header.sh_type == SHT_REL && gelf_getrel(data, static_cast<int>(i), &without) != nullptr)
                places.insert(GELF_R_SYM(without.r_info));
        }
    }
    return places;
}

/// With `all`, also those that nothing looks up.
void add_symbols(Elf* elf, bool all, Symbols& symbols)
{
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(section, &header) == nullptr || header.sh_type != SHT_DYNSYM || header.sh_entsize == 0)
            continue;
        Elf_Data* data = elf_getdata(section, nullptr);
        const auto count = header.sh_size / header.sh_entsize;
        const std::set<std::size_t> wanted = looked_up(elf, section);
        for (std::size_t i = 1;
             data != nullptr && i < count && !symbols.defined.overflown() && !symbols.undefined.overflown(); ++i) {
            GElf_Sym symbol;
            const char* name = nullptr;
            if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) break;
            if ((name = elf_strptr(elf, header.sh_link, symbol.st_name)) == nullptr) continue;
            if (symbol.st_shndx == SHN_UNDEF) {
                // A library without relocations would be none of ours: then all names count.
                if (all || wanted.empty() || wanted.contains(i)) symbols.undefined.add(cut(name, caps::symbol));
            } else if (GELF_ST_BIND(symbol.st_info) != STB_LOCAL) {
                symbols.defined.add(cut(name, caps::symbol));
            }
        }
    }
}

/// Does a function's code lie in the file? Of one that the linker left out, since nothing called it, the addresses
/// begin at 0.
bool has_code(Dwarf_Die* die)
{
    Dwarf_Addr base = 0;
    Dwarf_Addr begin = 0;
    Dwarf_Addr end = 0;
    for (std::ptrdiff_t next = 0; (next = dwarf_ranges(die, next, &base, &begin, &end)) > 0;)
        if (begin != 0) return true;
    return false;
}

/// The functions of a file's debug information, and what became of each.
struct Functions {
    Names<Function> used;      ///< left code: has an address, or was inlined into one that has
    Names<Function> left_out;  ///< was inlined only into functions that the linker left out
    Names<Function> unplaced;  ///< was inlined, and nothing says where

    [[nodiscard]] bool overflown() const { return used.overflown() || left_out.overflown() || unplaced.overflown(); }
};

std::string bare_name(Dwarf_Die* die)
{
    Dwarf_Attribute attribute;
    const char* const text = dwarf_formstring(dwarf_attr_integrate(die, DW_AT_name, &attribute));
    if (text == nullptr) return {};
    const std::string name = cut(text, caps::name);
    return name.starts_with("operator") ? name : name.substr(0, name.find('<'));
}

void add_function(Dwarf_Die* die, Names<Function>& functions)
{
    Dwarf_Attribute attribute;
    for (const unsigned kind : {DW_AT_linkage_name, DW_AT_MIPS_linkage_name, DW_AT_name}) {
        if (dwarf_attr_integrate(die, kind, &attribute) == nullptr) continue;
        const char* const name = dwarf_formstring(&attribute);
        if (name == nullptr) return;
        const char* const file = dwarf_decl_file(die);
        Function function{demangled(name, caps::name), file == nullptr ? "" : cut(file, caps::symbol), 0, 0,
                          bare_name(die)};
        if (dwarf_decl_line(die, &function.line) != 0) function.line = 0;
        if (dwarf_decl_column(die, &function.column) != 0) function.column = 0;
        functions.add(std::move(function));
        return;
    }
}

/// Looks at everything in a unit, whatever it lies in and however deep: code in a union, or in a hundred blocks, is
/// code too. False if the tree is deeper than any that a compiler writes, as a forged one may be.
bool walk(Dwarf_Die* unit, Functions& functions)
{
    constexpr std::size_t deepest = 65536;
    struct Place {
        Dwarf_Die die;
        bool left_out;  ///< the code round it is not in the file
    };
    std::vector<Place> path;
    Dwarf_Die first;
    if (dwarf_child(unit, &first) != 0) return true;
    path.push_back({first, false});
    while (!path.empty() && !functions.overflown()) {
        Place& here = path.back();
        const int tag = dwarf_tag(&here.die);
        bool gone = here.left_out;
        if (tag == DW_TAG_subprogram) {
            const bool has_addresses =
                dwarf_hasattr(&here.die, DW_AT_low_pc) != 0 || dwarf_hasattr(&here.die, DW_AT_ranges) != 0;
            gone = has_addresses && !has_code(&here.die);
            if (has_addresses)
                add_function(&here.die, gone ? functions.left_out : functions.used);
            else if (dwarf_hasattr(&here.die, DW_AT_inline) != 0)
                add_function(&here.die, functions.unplaced);
        } else if (tag == DW_TAG_inlined_subroutine) {
            add_function(&here.die, gone ? functions.left_out : functions.used);
        }
        Dwarf_Die child;
        if (dwarf_child(&here.die, &child) == 0) {
            if (path.size() == deepest) return false;
            path.push_back({child, gone});
            continue;
        }
        // The next one that was not seen yet: behind this one, or behind what it lies in.
        while (!path.empty() && dwarf_siblingof(&path.back().die, &path.back().die) != 0) path.pop_back();
    }
    return true;
}

/// Those that left code, or all. One of which nothing says where it was inlined left some: what it did may have become
/// part of others' code.
Names<Function> functions_in(const Functions& found, bool all)
{
    Names<Function> functions = found.used;
    for (const Function& function : found.unplaced.all())
        if (all || !found.left_out.all().contains(function)) functions.add(function);
    for (const Function& function : found.left_out.all())
        if (all) functions.add(function);
    return functions;
}

}

std::string names_as_json(Elf* elf, Dwarf* dwarf, const std::vector<std::string>& interface_names)
{
    Symbols symbols;
    add_symbols(elf, false, symbols);
    nlohmann::json missing = nlohmann::json::array();
    for (const std::string& name : interface_names)
        if (!symbols.defined.all().contains(name)) missing.push_back(demangled(name.c_str(), caps::name));
    // What was written for the interface under another name is left out as unused, and it is that which must be told.
    const bool all = !missing.empty();
    if (all) add_symbols(elf, true, symbols);
    Functions found;
    bool walked = true;
    const bool whole = for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        walked = walk(unit, found) && walked;
        return false;
    });
    const Names<Function> functions = functions_in(found, all);
    if (!whole || !walked || functions.all().empty() || functions.overflown() || found.overflown() ||
        symbols.defined.overflown() || symbols.undefined.overflown())
        return {};
    nlohmann::json undefined = nlohmann::json::array();
    for (const std::string& name : symbols.undefined.all())
        undefined.push_back({name, demangled(name.c_str(), caps::name)});
    nlohmann::json used = nlohmann::json::array();
    for (const Function& one : functions.all()) used.push_back({one.name, one.file, one.line, one.column, one.bare});
    const nlohmann::json json = {{"missing", missing},
                                 {"undefined", undefined},
                                 {"functions", used},
                                 {"uncounted", uncounted_code(elf)},
                                 {"own_memory", own_memory(elf)}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}
