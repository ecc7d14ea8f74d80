#include "build/padding_fault.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "model/random_text.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// "D.12 = &t + 8;" is {"D.12", "&t", 8}.
struct Sum {
    std::string_view name;
    std::string_view base;
    std::uint64_t added;
};

/// "MEM <char[7]> [(struct T *)&t + 9B] = {};" is {"&t", 9}.
struct Filled {
    std::string_view base;
    std::uint64_t offset;
};

std::optional<std::uint64_t> number(std::string_view text)
{
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// The words around the first " + ", if what follows it is a number with this behind.
std::optional<Sum> sum(std::string_view text, std::string_view behind)
{
    const std::size_t plus = text.find(" + ");
    if (plus == std::string_view::npos || !text.ends_with(behind)) return std::nullopt;
    const auto added = number(text.substr(plus + 3, text.size() - plus - 3 - behind.size()));
    return added ? std::optional(Sum{{}, text.substr(0, plus), *added}) : std::nullopt;
}

std::optional<Sum> assigned_sum(std::string_view line)
{
    const std::size_t equals = line.find(" = ");
    if (equals == std::string_view::npos) return std::nullopt;
    auto found = sum(line.substr(equals + 3), ";");
    if (found) found->name = line.substr(0, equals);
    return found;
}

std::optional<Filled> filled(std::string_view line)
{
    const std::size_t cast = line.find("*)");
    if (!line.starts_with("MEM <char[") || cast == std::string_view::npos) return std::nullopt;
    const auto found = sum(line.substr(cast + 2), "B] = {};");
    return found ? std::optional(Filled{found->base, found->added}) : std::nullopt;
}

/// What loops over arrays are made of, between fills.
bool is_of_a_loop(std::string_view line)
{
    return line.starts_with("goto <") || line.starts_with("if (D.") || line.starts_with("<D.");
}

/// An array within a value, as a loop over it names it.
struct Array {
    std::string pointer;  ///< "D.12", which goes from element to element
    std::string base;     ///< "&t"
    std::uint64_t begin = 0;
};

/// Reads one run of fills and loops over arrays.
class Run {
public:
    /// The next line. False if it ends the run.
    bool takes(std::string_view line)
    {
        if (const auto fill = filled(line)) {
            const auto end = ends_.find(fill->base);
            fault_ = fault_ || (!fresh_ && end != ends_.end() && fill->offset < end->second);
            return true;
        }
        if (const auto one = assigned_sum(line)) {
            // "D.12 = &t + 8;", "_1 = D.12 + 128;", and "D.12 = D.12 + 32;" for the next element.
            if (one->name.starts_with('_') && one->base == array_.pointer)
                ends_[array_.base] = array_.begin + one->added;
            else if (one->name != one->base)
                array_ = {std::string(one->name), std::string(one->base), one->added};
            return true;
        }
        return is_of_a_loop(line);
    }
    [[nodiscard]] bool fault() const { return fault_; }
    /// A variable that nothing was written to as yet loses nothing.
    void begin(bool fresh)
    {
        fresh_ = fresh;
        ends_.clear();
        array_ = {};
    }

private:
    std::map<std::string, std::uint64_t, std::less<>> ends_;  ///< of the last array of each value
    Array array_;
    bool fresh_ = false;
    bool fault_ = false;
};

}

bool has_padding_fault(std::istream& lowered)
{
    Run run;
    bool inside = false;
    bool fresh = false;
    for (std::string text; !run.fault() && std::getline(lowered, text);) {
        std::string_view line = text;
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!inside) run.begin(fresh);
        inside = run.takes(line);
        if (!inside) fresh = line.find(" = .DEFERRED_INIT (") != std::string_view::npos;
    }
    return run.fault();
}

LoweredText::LoweredText(const fs::path& work) : folder_(work / random_text()) { fs::create_directory(folder_); }

LoweredText::~LoweredText()
{
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::vector<std::string> LoweredText::options() const
{
    return {"-fdump-tree-lower", "-dumpdir", folder_.filename().string() + "/"};
}

bool LoweredText::has_padding_fault() const
{
    return std::ranges::any_of(fs::directory_iterator(folder_), [](const fs::directory_entry& entry) {
        if (entry.path().extension() != ".lower") return false;
        std::ifstream lowered(entry.path());
        return grader::has_padding_fault(lowered);
    });
}

Toolchain without_filling(Toolchain tools)
{
    std::erase_if(tools.flags, [](const std::string& flag) { return flag.starts_with("-ftrivial-auto-var-init="); });
    return tools;
}

}
