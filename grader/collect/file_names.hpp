#pragma once

#include <string>
#include <string_view>

namespace umbral::grader {

/// What a file is, by its suffix alone, in any case. Of "sphere.cpp.txt", as mail programs make it, ".txt" does not
/// count.
enum class FileKind {
    source,   ///< .cpp .cc .cxx .c++
    header,   ///< .hpp .h .hh .hxx
    shader,   ///< .glsl .vert .frag .geom .comp
    archive,  ///< .zip .tar .tar.gz .tgz .tar.bz2 .tbz2 .tar.xz .txz .7z, and .rar to be refused
    other
};
[[nodiscard]] FileKind kind_of(std::string_view name);
/// Does the grader read files of this kind?
[[nodiscard]] constexpr bool is_code(FileKind kind)
{
    return kind == FileKind::source || kind == FileKind::header || kind == FileKind::shader;
}

/// Is this a folder or file that tools make and nobody hands in on purpose: .git, __MACOSX, CMakeFiles, node_modules,
/// ._sphere.cpp?
[[nodiscard]] bool is_junk(std::string_view name);

/// Is this the folder include/umbral, in which `umbral new` puts the framework's headers for editors? Nobody's own work
/// lies there.
[[nodiscard]] bool is_framework_copy(std::string_view folder);

/// The last part of a path, and what stands before it without the '/'.
[[nodiscard]] std::string_view last_part(std::string_view path);
[[nodiscard]] std::string_view parent_part(std::string_view path);

/// The name of an archive without its suffix: "ana" of "ana.tar.gz"; any other name as it is.
[[nodiscard]] std::string_view without_archive_suffix(std::string_view name);

/// What names of the same file have in common: "view_matrix.cpp" of "View-Matrix (1).cc", "ViewMatrix - Copy.cpp" and
/// "Copia de view_matrix.cpp" alike is "viewmatrix.cpp". Lower case; no spaces, hyphens, underscores; no mark of a
/// copy; .cpp for a C++ source with any suffix. Of a folder's name the same, but for the suffix.
[[nodiscard]] std::string file_key(std::string_view name);
[[nodiscard]] std::string folder_key(std::string_view name);

}
