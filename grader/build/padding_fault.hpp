#pragma once

#include <filesystem>
#include <istream>

#include "build/toolchain.hpp"

namespace umbral::grader {

/// Has g++ write down each function after padding was filled, into files of the folder in which it runs.
inline constexpr const char* dump_for_padding_fault = "-fdump-tree-lower";

/// Does g++'s text of a file's functions overwrite a member? With -ftrivial-auto-var-init, g++ fills the padding of a
/// value that is made of a list (`Joint{1, matrix, true}`) after its members were written. Behind an array of structs
/// or matrix columns of more than 64 bytes, g++ 12 takes that padding to begin at the array's place: a zero lands on
/// the array's first numbers, and right work gives wrong answers. The text shows it: a loop over the array, and behind
/// it a store into the value at a place before the array's end.
[[nodiscard]] bool has_padding_fault(std::istream& lowered);

/// … in one of the files that `dump_for_padding_fault` left in this folder.
[[nodiscard]] bool padding_fault_in(const std::filesystem::path& folder);

/// The same tools, with variables left as they are.
[[nodiscard]] Toolchain without_filling(Toolchain tools);

}
