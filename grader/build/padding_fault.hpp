#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "build/toolchain.hpp"

namespace umbral::grader {

/// Does g++'s text of a file's functions overwrite a member? With -ftrivial-auto-var-init, g++ fills the padding of a
/// value that is made of a list (`Joint{1, matrix, true}`) after its members were written. Behind an array of structs
/// or matrix columns of more than 64 bytes, g++ 12 takes that padding to begin at the array's place: a zero lands on
/// the array's first numbers, and right work gives wrong answers. The text shows it: a loop over the array, and behind
/// it a store into the value at a place before the array's end.
[[nodiscard]] bool has_padding_fault(std::istream& lowered);

/// What g++ writes down of each function after padding was filled: files in a folder of their own below the one in
/// which it runs. The folder's name cannot be guessed, since what is compiled may ask for files: one that is there only
/// now would tell it that it is not just being looked through. Gone when this goes out of scope.
class LoweredText {
public:
    explicit LoweredText(const std::filesystem::path& work);
    LoweredText(const LoweredText&) = delete;
    LoweredText& operator=(const LoweredText&) = delete;
    ~LoweredText();

    /// What g++ is told to write them.
    [[nodiscard]] std::vector<std::string> options() const;
    /// Has one of them the fault?
    [[nodiscard]] bool has_padding_fault() const;

private:
    std::filesystem::path folder_;
};

/// The same tools, with variables left as they are.
[[nodiscard]] Toolchain without_filling(Toolchain tools);

/// What `compile(tools, more options)` makes with variables filled; made once more without, where g++ overwrote what
/// the sources wrote. `is_built` says of a result whether anything was made.
template <class Compile, class IsBuilt>
[[nodiscard]] auto compiled_as_written(const Toolchain& tools, const std::filesystem::path& work,
                                       const Compile& compile, const IsBuilt& is_built)
{
    const Toolchain unfilled = without_filling(tools);
    if (unfilled.flags == tools.flags) return compile(tools, std::vector<std::string>());
    const LoweredText lowered(work);
    auto result = compile(tools, lowered.options());
    if (is_built(result) && lowered.has_padding_fault()) result = compile(unfilled, std::vector<std::string>());
    return result;
}

}
