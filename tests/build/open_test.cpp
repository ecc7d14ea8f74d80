#include <fcntl.h>
#include <gelf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "inspect/open.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

// Which files libdw is given: what it takes for granted is checked before.
namespace umbral::grader {
namespace {

using umbral::test::TemporaryFolder;

/// A library with debug information, as g++ makes it with these options.
std::string compiled(const std::string& options)
{
    const TemporaryFolder folder;
    folder.write("one.cpp", "int one(int x) { return x + 1; }\n");
    std::string command = UMBRAL_COMPILER;
    for (const std::string& word : {std::string("-g -gdwarf-5 -shared -fPIC"), options,
                                    "-o " + (folder / "one.so").string(), (folder / "one.cpp").string()})
        command += " " + word;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return umbral::test::read(folder / "one.so");
}

bool opens(std::string image)
{
    elf_version(EV_CURRENT);
    Elf* const elf = elf_memory(image.data(), image.size());
    Dwarf* const dwarf = elf == nullptr ? nullptr : open_debug_information(elf);
    const bool opened = dwarf != nullptr;
    if (opened) (void)dwarf_end(dwarf);
    (void)elf_end(elf);
    return opened;
}

/// The same with another last byte in a section.
std::string with_last_byte(std::string image, const std::string& wanted, char last)
{
    elf_version(EV_CURRENT);
    Elf* const elf = elf_memory(image.data(), image.size());
    std::size_t names = 0;
    EXPECT_EQ(elf_getshdrstrndx(elf, &names), 0);
    std::size_t end = 0;
    for (Elf_Scn* section = elf_nextscn(elf, nullptr); section != nullptr; section = elf_nextscn(elf, section)) {
        GElf_Shdr header;
        if (gelf_getshdr(section, &header) != nullptr && elf_strptr(elf, names, header.sh_name) == wanted)
            end = header.sh_offset + header.sh_size;
    }
    (void)elf_end(elf);
    EXPECT_GT(end, 0U) << wanted;
    if (end > 0) image[end - 1] = last;
    return image;
}

TEST(OpenDebugInformation, takes_what_the_compiler_writes)
{
    const std::string library = compiled("");
    EXPECT_TRUE(opens(library));
    EXPECT_TRUE(opens(with_last_byte(library, ".debug_line_str", '\0')));
    EXPECT_FALSE(opens(""));
    EXPECT_FALSE(opens(library.substr(0, 100)));
}

TEST(OpenDebugInformation, refuses_strings_without_an_end)
{
    const std::string library = compiled("");
    for (const char* const section : {".debug_str", ".debug_line_str"})
        EXPECT_FALSE(opens(with_last_byte(library, section, 'x'))) << section;
    for (const char* const found : {"unterminated_line_strings", "strings_without_bytes"})
        EXPECT_FALSE(opens(umbral::test::read(UMBRAL_SOURCE_DIR "/tests/fuzz/corpus/inspect/" + std::string(found))))
            << found;
}

TEST(OpenDebugInformation, refuses_what_is_compressed) { EXPECT_FALSE(opens(compiled("-gz=zlib"))); }

}
}
