#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
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

/// Takes numbers off data.
class NumberReader {
public:
    NumberReader(std::string_view data, PlyFormat format) : data_(data), format_(format) {}

    /// Zero where there is none, and from then on.
    template <class Number>
    Number take()
    {
        Number number{};
        if (format_ == PlyFormat::ascii) {
            data_.remove_prefix(std::min(data_.find_first_not_of(" \t\r\n"), data_.size()));
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

    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] std::string_view word() const { return word_; }

private:
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

/// What a file with float x, y, z and one list of corners holds; empty if it is something else, or of another format.
inline Decoded decoded(const std::string& file, PlyFormat format)
{
    std::istringstream header(file);
    header.imbue(std::locale::classic());
    std::string line;
    std::size_t counts[2] = {0, 0};
    std::string coordinates;
    PlyType length_type = PlyType::uint8;
    PlyType corner_type = PlyType::int32;
    bool same_format = false;
    while (std::getline(header, line) && line.substr(0, 10) != "end_header") {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::string word[5];
        for (std::string& w : word) words >> w;
        const std::string_view wanted[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        if (word[0] == "format") same_format = word[1] == wanted[static_cast<int>(format)];
        if (word[0] == "element")
            std::from_chars(word[2].data(), word[2].data() + word[2].size(), counts[word[1] == "face" ? 1 : 0]);
        if (word[0] == "property" && word[1] == "list") {
            length_type = ply_type(word[2]).value_or(length_type);
            corner_type = ply_type(word[3]).value_or(corner_type);
        } else if (word[0] == "property") {
            coordinates += word[1] + word[2] + ' ';
        }
    }
    Decoded result;
    if (!header || !same_format ||
        (coordinates != "floatx floaty floatz " && coordinates != "float32x float32y float32z "))
        return result;
    NumberReader numbers(std::string_view(file).substr(static_cast<std::size_t>(header.tellg())), format);
    const auto whole = [&](PlyType type) {
        return with_ply_type(type, [&](auto zero) { return static_cast<double>(numbers.take<decltype(zero)>()); });
    };
    for (std::size_t i = 0; i < 3 * counts[0]; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(numbers.take<float>());
        if (numbers.failed()) return result;
        result.position_bits.push_back(bits);
        if (format == PlyFormat::ascii) result.digits.push_back(significant_digits(numbers.word()));
    }
    for (std::size_t i = 0; i < counts[1]; ++i) {
        std::vector<std::uint32_t> face;
        for (double left = whole(length_type); left > 0 && !numbers.failed(); --left) {
            const double corner = whole(corner_type);
            face.push_back(corner >= 0 && corner < 4294967295.0 ? static_cast<std::uint32_t>(corner) : 4294967295U);
        }
        if (numbers.failed()) return result;
        result.faces.push_back(face);
    }
    return result;
}

}
