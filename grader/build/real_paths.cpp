#include "build/real_paths.hpp"

#include <cstdlib>
#include <filesystem>
#include <memory>

namespace umbral::grader {
namespace {

/// A file that is not there, or none of this machine's, is nobody's header, whatever else its path says.
constexpr std::size_t longest_real_path = 1024;

/// One that goes up from the folder in which the compiler ran leads up to the root, if it leads to a header at all.
std::string real_path(const std::string& path)
{
    const std::string whole = path.starts_with('/') ? path : "/" + path;
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(whole.c_str(), nullptr), &std::free);
    if (real) return real.get();
    std::string plain = std::filesystem::path(path).lexically_normal().string();
    if (plain.size() > longest_real_path) plain.resize(longest_real_path);
    return plain;
}

}

const std::string& RealPaths::of(const std::string& path)
{
    const auto [entry, is_new] = known_.try_emplace(path, path);
    if (is_new && path.find('/') != std::string::npos && !too_many()) entry->second = real_path(path);
    return entry->second;
}

}
