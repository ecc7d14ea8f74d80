#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace umbral::grader {

/// Is this how a ScratchFolder's directory is called?
[[nodiscard]] inline bool is_scratch_name(std::string_view name)
{
    return name.starts_with("work-") && name.size() == 11;
}

/// A fresh directory that only this user can enter, removed with all it holds when it goes out of scope.
class ScratchFolder {
public:
    /// Makes it below `parent` (made too, if missing). Throws std::system_error.
    explicit ScratchFolder(const std::filesystem::path& parent)
    {
        std::filesystem::create_directories(parent);
        std::string name = (parent / "work-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), "making a directory in " + parent.string());
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
};

}
