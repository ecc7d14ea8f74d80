#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <umbral/meshes/ply.hpp>
#include <umbral/meshes/ply_types.hpp>
#include <vector>

/// What stands in a file that the unit wrote: as little of PLY as it may use.
namespace umbral::meshes {

struct Decoded {
    std::vector<std::uint32_t> position_bits;  ///< of x, y, z, x, …
    std::vector<std::uint32_t> digits;         ///< in ASCII: how many each coordinate has, without zeros at both ends
    std::vector<std::vector<std::uint32_t>> faces;
};

/// A float's bits; the same for every NaN.
inline std::uint32_t bits_of(float number)
{
    return std::isnan(number) ? 0x7FC00000U : std::bit_cast<std::uint32_t>(number);
}

/// Takes numbers off data. In ASCII each element has a line of its own, and blank lines do not count.
class NumberReader {
public:
    NumberReader(std::string_view data, PlyFormat format) : data_(data), format_(format) {}

    /// Zero where there is none, and from then on.
    template <class Number>
    Number take()
    {
        Number number{};
        if (format_ == PlyFormat::ascii) {
            skip(" \t\r");
            const auto [end, error] = std::from_chars(data_.data(), data_.data() + data_.size(), number);
            if (error != std::errc()) return fail<Number>();
            word_ = data_.substr(0, static_cast<std::size_t>(end - data_.data()));
            data_.remove_prefix(word_.size());
        } else {
            std::array<char, sizeof number> bytes;
            if (data_.size() < bytes.size()) return fail<Number>();
            std::memcpy(bytes.data(), data_.data(), bytes.size());
            data_.remove_prefix(bytes.size());
            if ((format_ == PlyFormat::big_endian) != (std::endian::native == std::endian::big))
                std::reverse(bytes.begin(), bytes.end());
            number = std::bit_cast<Number>(bytes);
        }
        return number;
    }

    void begin_element()
    {
        if (format_ == PlyFormat::ascii) skip(" \t\r\n");
    }

    void end_element()
    {
        if (format_ != PlyFormat::ascii) return;
        skip(" \t\r");
        if (!data_.empty() && data_.front() != '\n') fail<int>();
    }

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] std::string_view word() const { return word_; }

private:
    void skip(const char* blanks) { data_.remove_prefix(std::min(data_.find_first_not_of(blanks), data_.size())); }

    template <class Number>
    Number fail()
    {
        failed_ = true;
        data_ = {};
        return {};
    }

    std::string_view data_;
    PlyFormat format_;
    std::string_view word_;  // the last one, of ASCII
    bool failed_ = false;
};

/// How many digits a decimal has from the first to the last that is not 0, its exponent left out.
inline std::uint32_t significant_digits(std::string_view word)
{
    std::uint32_t count = 0;
    std::uint32_t zeros = 0;
    for (const char c : word.substr(0, word.find_first_of("eE"))) {
        if (c == '0')
            ++zeros;
        else if (c > '0' && c <= '9')
            count += (count == 0 ? 0 : zeros) + 1, zeros = 0;
    }
    return count;
}

/// A header's lines without comments and format, the counts and the types of its list taken out.
struct Outline {
    std::string text;
    std::string format;
    std::size_t counts[2] = {0, 0};  ///< of vertices, of faces
    PlyType length_type = PlyType::uint8;
    PlyType corner_type = PlyType::int32;
};

inline Outline outline_of(std::istream& header)
{
    Outline outline;
    std::size_t elements = 0;
    for (std::string line; outline.text.find("end_header") == std::string::npos && std::getline(header, line);) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::vector<std::string> word;
        for (std::string w; words >> w;) word.push_back(w == "float32" && word.size() == 1 ? "float" : w);
        if (word.empty() || word[0] == "comment" || word[0] == "obj_info") continue;
        if (word[0] == "element" && word.size() == 3 && elements < 2) {
            std::from_chars(word[2].data(), word[2].data() + word[2].size(), outline.counts[elements++]);
            word.pop_back();
        } else if (word[0] == "property" && word.size() == 5 && ply_type(word[2]) && ply_type(word[3])) {
            outline.length_type = *ply_type(word[2]);
            outline.corner_type = *ply_type(word[3]);
            word.erase(word.begin() + 2, word.begin() + 4);
        }
        std::string& text = word[0] == "format" ? outline.format : outline.text;
        for (const std::string& w : word) text += w + ' ';
    }
    return outline;
}

/// What a file with float x, y, z and one list of corners holds; empty if it is something else, or of another format.
inline Decoded decoded(const std::string& file, PlyFormat format)
{
    std::istringstream header(file);
    header.imbue(std::locale::classic());
    const auto [text, format_line, counts, length_type, corner_type] = outline_of(header);
    Decoded result;
    const std::string_view formats[] = {"format ascii 1.0 ", "format binary_little_endian 1.0 ",
                                        "format binary_big_endian 1.0 "};
    if (!header || format_line != formats[static_cast<int>(format)] ||
        text !=
            "ply element vertex property float x property float y property float z element face property list "
            "vertex_indices end_header ")
        return result;
    NumberReader numbers(std::string_view(file).substr(static_cast<std::size_t>(header.tellg())), format);
    const auto whole = [&](PlyType type) {
        return with_ply_type(type, [&](auto zero) { return static_cast<double>(numbers.take<decltype(zero)>()); });
    };
    for (std::size_t i = 0; i < 3 * counts[0]; ++i) {
        if (i % 3 == 0) numbers.begin_element();
        const std::uint32_t bits = bits_of(numbers.take<float>());
        if (i % 3 == 2) numbers.end_element();
        if (numbers.failed()) return result;
        result.position_bits.push_back(bits);
        if (format == PlyFormat::ascii) result.digits.push_back(significant_digits(numbers.word()));
    }
    for (std::size_t i = 0; i < counts[1]; ++i) {
        std::vector<std::uint32_t> face;
        numbers.begin_element();
        for (double left = whole(length_type); left > 0 && !numbers.failed(); --left) {
            const double corner = whole(corner_type);
            face.push_back(corner >= 0 && corner < 4294967295.0 ? static_cast<std::uint32_t>(corner) : 4294967295U);
        }
        numbers.end_element();
        if (numbers.failed()) return result;
        result.faces.push_back(face);
    }
    return result;
}

}
