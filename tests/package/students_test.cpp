#include <elf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string_view>

#include "installation.hpp"

// What students get, searched for whatever would tell an answer.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

const fs::path source = UMBRAL_SOURCE;

std::string_view trimmed(std::string_view line)
{
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
    return line;
}

/// The lines of a text, or of the texts within a binary, without the space around them.
template <class Visit>
void each_line(const std::string& text, Visit visit)
{
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        if (at < text.size() && text[at] != '\n' && text[at] != '\0') continue;
        visit(trimmed(std::string_view(text).substr(begin, at - begin)));
        begin = at + 1;
    }
}

/// Code that says something: long enough not to be anybody's, and neither an include nor a comment.
bool is_telling(std::string_view line)
{
    return line.size() >= 24 && !line.starts_with("#include") && !line.starts_with("//") && !line.starts_with("///") &&
           !line.starts_with("*") && line.find_first_of("();=") != std::string_view::npos;
}

/// A line of GLSL, as far as one line tells.
bool is_shader(std::string_view line)
{
    if (line.find("::") != std::string_view::npos) return false;
    return std::ranges::any_of(
        std::array{"vec2", "vec3", "vec4", "mat3", "mat4", "gl_Position", "texture(", "normalize(", ".xyz", "normal;"},
        [&](const char* word) { return line.find(word) != std::string_view::npos; });
}

using Lines = std::set<std::string, std::less<>>;

void add_lines(Lines& lines, const fs::path& file)
{
    each_line(read(file), [&](std::string_view line) {
        if (is_telling(line)) lines.emplace(line);
    });
}

bool is_code(const fs::path& file)
{
    static const std::set<std::string> suffixes{".cpp", ".hpp", ".vert", ".frag"};
    return suffixes.contains(file.extension().string());
}

/// Lines of references, oracles, mistakes and alternatives, but for those that students are given: stubs, statements,
/// interfaces.
Lines telling_lines()
{
    Lines lines;
    for (const auto& topic : fs::directory_iterator(source / "exercises"))
        if (const fs::path answers = source / "reference" / topic.path().filename(); fs::is_directory(answers))
            for (const fs::path& file : files_below(answers))
                if (is_code(file)) add_lines(lines, file);
    Lines given;
    Lines drivers;
    for (const fs::path& file : files_below(source / "exercises")) {
        const std::string folder = file.parent_path().filename().string();
        if (folder == "mistakes" || folder == "alternatives") {
            // The header of a mistake is what students are told.
            std::string text = read(file);
            if (const std::size_t change = text.find("\n---\n"); change != std::string::npos) text.erase(0, change);
            each_line(text, [&](std::string_view line) {
                if (is_telling(line)) lines.emplace(line);
            });
        } else {
            add_lines(file.filename() == "driver.cpp" || file.extension() == ".hpp" ? drivers : given, file);
        }
    }
    for (const fs::path& file : files_below(source / "framework"))
        if (file.extension() == ".hpp") add_lines(given, file);
    std::erase_if(lines, [&](const std::string& line) { return given.contains(line); });
    // Drivers draw with shaders of their own, in which the same vectors have the same names: some lines, and no more.
    EXPECT_LT(std::ranges::count_if(drivers,
                                    [&](const std::string& line) { return lines.contains(line) && is_shader(line); }),
              16);
    std::erase_if(lines, [&](const std::string& line) { return drivers.contains(line) && is_shader(line); });
    return lines;
}

TEST(StudentsComponent, holds_no_line_of_an_answer)
{
    const Lines lines = telling_lines();
    ASSERT_GT(lines.size(), 3000U);
    for (const fs::path& file : files_below(students().prefix())) {
        const std::string text = read(file);
        each_line(text,
                  [&](std::string_view line) { EXPECT_FALSE(lines.contains(line)) << file << " holds: " << line; });
    }
}

TEST(StudentsComponent, holds_no_file_of_an_answer)
{
    const std::set<std::string> answers{"mistakes", "alternatives", "reference"};
    const fs::path data = students().prefix() / "share" / "umbral";
    for (const fs::path& file : files_below(data)) {
        for (const fs::path& part : fs::relative(file, data)) EXPECT_FALSE(answers.contains(part.string())) << file;
        EXPECT_NE(file.filename(), "driver.cpp") << file;
        // Of C++ only interfaces and stubs: a stub is in every unit's list of files, and says that it is one.
        if (file.extension() != ".cpp") continue;
        EXPECT_NE(read(file).find("not_implemented"), std::string::npos) << file;
    }
}

/// The names of an ELF file's sections.
std::set<std::string> sections_of(const std::string& text)
{
    Elf64_Ehdr header;
    std::memcpy(&header, text.data(), sizeof header);
    std::vector<Elf64_Shdr> sections(header.e_shnum);
    std::memcpy(sections.data(), text.data() + header.e_shoff, sections.size() * sizeof(Elf64_Shdr));
    std::set<std::string> names;
    for (const Elf64_Shdr& section : sections)
        names.insert(text.data() + sections.at(header.e_shstrndx).sh_offset + section.sh_name);
    return names;
}

TEST(StudentsComponent, has_neither_symbols_nor_debug_information)
{
    std::size_t seen = 0;
    for (const fs::path& file : files_below(students().prefix())) {
        const std::string text = read(file);
        if (!text.starts_with(ELFMAG)) continue;
        ++seen;
        for (const std::string& name : sections_of(text))
            EXPECT_FALSE(name.starts_with(".debug") || name == ".symtab") << file << name;
    }
    EXPECT_GT(seen, 50U);
}

TEST(StudentsComponent, is_there_for_everybody_and_written_by_nobody_else)
{
    for (const auto& entry : fs::recursive_directory_iterator(students().prefix())) {
        if (entry.is_symlink()) continue;
        const auto bits = entry.status().permissions();
        EXPECT_NE(bits & fs::perms::others_read, fs::perms::none) << entry.path();
        EXPECT_EQ(bits & (fs::perms::others_write | fs::perms::group_write), fs::perms::none) << entry.path();
    }
}

}
}
