#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "fuzz.hpp"
#include "inspect/names.hpp"
#include "inspect/open.hpp"
#include "inspect/places.hpp"

// What umbral-inspect does with a compiled library: hostile ELF and DWARF. The library that takes them apart is not
// instrumented, so that the fuzzer sees only what we do with its answers; what crashes it ends the process all the
// same.

// libdw 0.188 loses some bytes where it refuses a damaged table of lines; umbral-inspect ends after one file.
extern "C" const char* __lsan_default_suppressions() { return "leak:libdw"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    elf_version(EV_CURRENT);
    std::vector<char> image(data, data + size);
    Elf* const elf = elf_memory(image.data(), image.size());
    Dwarf* const dwarf = elf == nullptr ? nullptr : grader::open_debug_information(elf);
    if (dwarf != nullptr) {
        const std::string json = grader::names_as_json(elf, dwarf, {"_Z6spherev"});
        for (const Dwarf_Addr address : {Dwarf_Addr{0}, Dwarf_Addr{0x1000}, Dwarf_Addr{0x1139}, ~Dwarf_Addr{0}}) {
            const auto place = grader::place_in_own_files(dwarf, address);
            tests::expect(!place || place->file.size() <= 4096, "a place without end");
        }
        (void)dwarf_end(dwarf);
    }
    (void)elf_end(elf);
    return 0;
}
