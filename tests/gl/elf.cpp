#include "elf.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace umbral::gl {
namespace {

class File {
public:
    explicit File(const std::string& path)
    {
        std::ifstream file(path, std::ios::binary);
        bytes_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        if (bytes_.size() < sizeof(Elf64_Ehdr) || std::memcmp(bytes_.data(), ELFMAG, SELFMAG) != 0)
            throw std::runtime_error(path + ": no ELF file");
        const auto header = read<Elf64_Ehdr>(0);
        for (std::size_t i = 0; i < header.e_shnum; ++i)
            sections.push_back(read<Elf64_Shdr>(header.e_shoff + i * sizeof(Elf64_Shdr)));
        names_ = sections.at(header.e_shstrndx).sh_offset;
    }

    template <class Item>
    [[nodiscard]] Item read(std::size_t offset) const
    {
        Item item;
        if (offset + sizeof item > bytes_.size()) throw std::runtime_error("ELF file: cut short");
        std::memcpy(&item, bytes_.data() + offset, sizeof item);
        return item;
    }
    [[nodiscard]] std::string text(std::size_t offset) const { return bytes_.data() + offset; }
    [[nodiscard]] std::string name(const Elf64_Shdr& section) const { return text(names_ + section.sh_name); }

    std::vector<Elf64_Shdr> sections;

private:
    std::vector<char> bytes_;
    std::size_t names_ = 0;
};

/// The loader makes .data.rel.ro read-only after relocation.
bool stays_writable(const File& file, const Elf64_Sym& symbol)
{
    if (symbol.st_shndx >= file.sections.size()) return true;
    const Elf64_Shdr& section = file.sections[symbol.st_shndx];
    return (section.sh_flags & SHF_WRITE) != 0 && !file.name(section).starts_with(".data.rel.ro");
}

}

Exports read_exports(const std::string& path)
{
    const File file(path);
    Exports found;
    for (const Elf64_Shdr& section : file.sections) {
        const bool symbols = section.sh_type == SHT_DYNSYM;
        if (!symbols && section.sh_type != SHT_DYNAMIC) continue;
        const std::size_t strings = file.sections.at(section.sh_link).sh_offset;
        for (std::size_t offset = 0; offset < section.sh_size; offset += section.sh_entsize) {
            if (!symbols) {
                const auto entry = file.read<Elf64_Dyn>(section.sh_offset + offset);
                if (entry.d_tag == DT_NEEDED) found.needed.push_back(file.text(strings + entry.d_un.d_val));
                continue;
            }
            const auto symbol = file.read<Elf64_Sym>(section.sh_offset + offset);
            if (symbol.st_shndx == SHN_UNDEF) continue;
            const std::string name = file.text(strings + symbol.st_name);
            if (ELF64_ST_BIND(symbol.st_info) == STB_GNU_UNIQUE) found.unique.push_back(name);
            if (ELF64_ST_TYPE(symbol.st_info) == STT_FUNC) found.functions.push_back(name);
            if (ELF64_ST_TYPE(symbol.st_info) == STT_OBJECT && stays_writable(file, symbol))
                found.writable_data.push_back(name);
        }
    }
    if (found.functions.empty()) throw std::runtime_error(path + ": exports no function");
    return found;
}

}
