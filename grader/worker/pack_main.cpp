#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <string_view>

#include "manifest/units.hpp"
#include "worker/packaged_unit.hpp"

// umbral-pack EXERCISES REFERENCE FOLDER UNIT…   writes what students' packages hold of the units' answers into
// FOLDER/UNIT umbral-pack --veil UNITS                       veils the libraries of answers below the folder UNITS Run
// when a package is made (packaged_unit.hpp).
int main(int count, char** words)
{
    namespace fs = std::filesystem;
    using namespace umbral::grader;
    const bool veil = count == 3 && std::string_view(words[1]) == "--veil";
    if (!veil && count < 4) {
        (void)std::fputs("usage: umbral-pack EXERCISES REFERENCE FOLDER UNIT…, or umbral-pack --veil UNITS\n", stderr);
        return 2;
    }
    try {
        if (veil) veil_libraries(words[2]);
        if (veil) return 0;
        for (const char* const unit : std::span(words + 4, words + count))
            write_packaged(words[2], load_exercise(fs::path(words[1]) / unit), fs::path(words[3]) / unit);
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral-pack: %s\n", error.what());
        return 1;
    }
}
