#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace umbral::grader {

/// What a new unit is called, in the spellings that its files need.
struct UnitName {
    std::string topic;  ///< "transforms": folder and namespace
    std::string unit;   ///< "my-unit": folder
    std::string file;   ///< "my_unit": files and functions
    std::string title;  ///< "My unit"
    std::string test;   ///< "MyUnit"
};

/// The name in "transforms/my-unit". Throws UsageError that says what was expected: a word for the topic, and words
/// joined by single hyphens for the unit, all in a-z and 0-9, beginning with a letter.
[[nodiscard]] UnitName read_unit_name(const std::string& id);

/// A template's text, or the name of its file, with @topic@, @unit@, @file@, @title@ and @test@ filled in.
[[nodiscard]] std::string filled_in(std::string text, const UnitName& name);

/// A file to be written.
struct NewFile {
    std::filesystem::path name;  ///< below the root of the sources
    std::string text;
};

/// The files of a new unit, sorted by name: for each template NAME.in below the folder `templates` the file NAME,
/// filled in, with its blocks of includes sorted as the project's format wants them. Throws
/// std::filesystem::filesystem_error if the folder cannot be read.
[[nodiscard]] std::vector<NewFile> files_of_new_unit(const std::filesystem::path& templates, const UnitName& name);

}
