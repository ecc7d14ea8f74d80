#include "inspect/names.hpp"

#include <dwarf.h>
#include <gelf.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "inspect/counted_code.hpp"
#include "inspect/demangle.hpp"
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

using Pair = std::pair<std::string, std::string>;

std::string cut(const char* name, std::size_t limit) { return {name, strnlen(name, limit)}; }

struct Symbols {
    Names<std::string> defined;
    Names<std::string> undefined;
};

void add_symbols(Elf* elf, Symbols& symbols)
{
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
        GElf_Shdr header;
        if (gelf_getshdr(section, &header) == nullptr || header.sh_type != SHT_DYNSYM || header.sh_entsize == 0)
            continue;
        Elf_Data* data = elf_getdata(section, nullptr);
        const auto count = header.sh_size / header.sh_entsize;
        for (std::size_t i = 1;
             data != nullptr && i < count && !symbols.defined.overflown() && !symbols.undefined.overflown(); ++i) {
            GElf_Sym symbol;
            const char* name = nullptr;
            if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) break;
            if ((name = elf_strptr(elf, header.sh_link, symbol.st_name)) == nullptr) continue;
            if (symbol.st_shndx == SHN_UNDEF)
                symbols.undefined.add(cut(name, caps::symbol));
            else if (GELF_ST_BIND(symbol.st_info) != STB_LOCAL)
                symbols.defined.add(cut(name, caps::symbol));
        }
    }
}

/// A subprogram that left code: it has an address, or a copy of it was inlined somewhere.
void add_function(Dwarf_Die* die, Names<Pair>& functions)
{
    Dwarf_Attribute attribute;
    if (dwarf_hasattr(die, DW_AT_low_pc) == 0 && dwarf_hasattr(die, DW_AT_inline) == 0 &&
        dwarf_hasattr(die, DW_AT_ranges) == 0)
        return;
    const char* const file = dwarf_decl_file(die);
    for (const unsigned kind : {DW_AT_linkage_name, DW_AT_MIPS_linkage_name, DW_AT_name}) {
        if (dwarf_attr_integrate(die, kind, &attribute) == nullptr) continue;
        if (const char* name = dwarf_formstring(&attribute))
            functions.add({demangled(name, caps::name), file == nullptr ? "" : cut(file, caps::symbol)});
        return;
    }
}

// Depth is bounded, since a forged tree could be as deep as its file is long.
void walk(Dwarf_Die* parent, int depth, Names<Pair>& functions)
{
    Dwarf_Die die;
    if (depth > 64 || dwarf_child(parent, &die) != 0) return;
    do {
        const int tag = dwarf_tag(&die);
        if (tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine) add_function(&die, functions);
        if (tag == DW_TAG_namespace || tag == DW_TAG_subprogram || tag == DW_TAG_structure_type ||
            tag == DW_TAG_class_type || tag == DW_TAG_lexical_block)
            walk(&die, depth + 1, functions);
    } while (!functions.overflown() && dwarf_siblingof(&die, &die) == 0);
}

}

std::string names_as_json(Elf* elf, Dwarf* dwarf, const std::vector<std::string>& interface_names)
{
    Symbols symbols;
    Names<Pair> functions;
    add_symbols(elf, symbols);
    const bool whole = for_each_unit(dwarf, [&](Dwarf_Die* unit) {
        walk(unit, 0, functions);
        return false;
    });
    if (!whole || functions.all().empty() || functions.overflown() || symbols.defined.overflown() ||
        symbols.undefined.overflown())
        return {};
    nlohmann::json missing = nlohmann::json::array();
    for (const std::string& name : interface_names)
        if (!symbols.defined.all().contains(name)) missing.push_back(demangled(name.c_str(), caps::name));
    nlohmann::json undefined = nlohmann::json::array();
    for (const std::string& name : symbols.undefined.all())
        undefined.push_back({name, demangled(name.c_str(), caps::name)});
    const nlohmann::json json = {{"missing", missing},
                                 {"undefined", undefined},
                                 {"functions", functions.all()},
                                 {"uncounted", uncounted_code(elf)}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}
