#include "collect/submission_id.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "model/digest.hpp"

namespace umbral::grader {
namespace {

struct Letters {
    std::string_view plain;
    std::string_view accented;  ///< UTF-8, one letter after the other
};

/// The letters of languages written in Latin script.
constexpr std::array<Letters, 60> alphabet{{
    {"A", "ÀÁÂÃÄÅĀĂĄǍḀẠẢẤẦẨẪẬẮẰẲẴẶ"},
    {"a", "àáâãäåāăąǎḁẚạảấầẩẫậắằẳẵặ"},
    {"AE", "Æ"},
    {"ae", "æ"},
    {"B", "ḂḄḆ"},
    {"b", "ḃḅḇ"},
    {"C", "ÇĆĈĊČḈ"},
    {"c", "çćĉċčḉ"},
    {"D", "ÐĎĐḊḌḎḐḒ"},
    {"d", "ðďđḋḍḏḑḓ"},
    {"E", "ÈÉÊËĒĔĖĘĚḔḖḘḚḜẸẺẼẾỀỂỄỆ"},
    {"e", "èéêëēĕėęěḕḗḙḛḝẹẻẽếềểễệ"},
    {"F", "Ḟ"},
    {"f", "ḟ"},
    {"G", "ĜĞĠĢḠ"},
    {"g", "ĝğġģḡ"},
    {"H", "ĤĦḢḤḦḨḪ"},
    {"h", "ĥħḣḥḧḩḫẖ"},
    {"I", "ÌÍÎÏĨĪĬĮİǏḬḮỈỊ"},
    {"i", "ìíîïĩīĭįıǐḭḯỉị"},
    {"IJ", "Ĳ"},
    {"ij", "ĳ"},
    {"J", "Ĵ"},
    {"j", "ĵ"},
    {"K", "ĶḰḲḴ"},
    {"k", "ķĸḱḳḵ"},
    {"L", "ĹĻĽĿŁḶḸḺḼ"},
    {"l", "ĺļľŀłḷḹḻḽ"},
    {"M", "ḾṀṂ"},
    {"m", "ḿṁṃ"},
    {"N", "ÑŃŅŇŊṄṆṈṊ"},
    {"n", "ñńņňŉŋṅṇṉṋ"},
    {"O", "ÒÓÔÕÖØŌŎŐƠǑṌṎṐṒỌỎỐỒỔỖỘỚỜỞỠỢ"},
    {"o", "òóôõöøōŏőơǒṍṏṑṓọỏốồổỗộớờởỡợ"},
    {"OE", "Œ"},
    {"oe", "œ"},
    {"P", "ṔṖ"},
    {"p", "ṕṗ"},
    {"R", "ŔŖŘṘṚṜṞ"},
    {"r", "ŕŗřṙṛṝṟ"},
    {"S", "ŚŜŞŠȘṠṢṤṦṨ"},
    {"s", "śŝşšſșṡṣṥṧṩẛ"},
    {"SS", "ẞ"},
    {"ss", "ß"},
    {"T", "ŢŤŦȚṪṬṮṰ"},
    {"t", "ţťŧțṫṭṯṱẗ"},
    {"Th", "Þ"},
    {"th", "þ"},
    {"U", "ÙÚÛÜŨŪŬŮŰŲƯǓǕǗǙǛṲṴṶṸṺỤỦỨỪỬỮỰ"},
    {"u", "ùúûüũūŭůűųưǔǖǘǚǜṳṵṷṹṻụủứừửữự"},
    {"V", "ṼṾ"},
    {"v", "ṽṿ"},
    {"W", "ŴẀẂẄẆẈ"},
    {"w", "ŵẁẃẅẇẉẘ"},
    {"X", "ẊẌ"},
    {"x", "ẋẍ"},
    {"Y", "ÝŶŸẎỲỴỶỸ"},
    {"y", "ýÿŷẏẙỳỵỷỹ"},
    {"Z", "ŹŻŽẐẒẔ"},
    {"z", "źżžẑẓẕ"},
}};

/// Bytes of the UTF-8 character that begins with `lead`.
constexpr std::size_t size_of(char lead)
{
    const auto byte = static_cast<unsigned char>(lead);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

std::map<std::string_view, std::string_view> by_letter()
{
    std::map<std::string_view, std::string_view> result;
    for (const Letters& letters : alphabet)
        for (std::string_view rest = letters.accented; !rest.empty(); rest.remove_prefix(size_of(rest.front())))
            result[rest.substr(0, size_of(rest.front()))] = letters.plain;
    return result;
}

/// `lower` is in small letters.
bool equal_in_any_case(std::string_view lower, std::string_view name)
{
    return std::ranges::equal(lower, name,
                              [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

/// Is this, up to its first point, what Windows takes for a device, wherever it lies?
bool is_device(std::string_view name)
{
    const std::string_view stem = name.substr(0, name.find('.'));
    const auto is = [&](std::string_view device) { return equal_in_any_case(device, stem); };
    const bool numbered = stem.size() == 4 && stem.back() >= '1' && stem.back() <= '9' &&
                          (equal_in_any_case("com", stem.substr(0, 3)) || equal_in_any_case("lpt", stem.substr(0, 3)));
    return numbered || is("con") || is("prn") || is("aux") || is("nul");
}

/// An accent that stands behind its letter (U+0300 to U+036F), as Macs write file names.
bool is_combining_accent(std::string_view character)
{
    return character.size() == 2 && (character[0] == '\xCC' || (character[0] == '\xCD' && character[1] < '\xB0'));
}

}

bool is_submission_id(std::string_view name)
{
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
               c == '-';
    };
    return !name.empty() && name.size() <= 128 && name != "." && name != ".." && std::ranges::all_of(name, plain);
}

bool is_reserved_id(std::string_view name)
{
    constexpr std::array<std::string_view, 3> written_by_reports{".json", ".html", ".csv"};
    return name.starts_with('.') || name.starts_with('-') || name.ends_with('.') || is_device(name) ||
           std::ranges::any_of(written_by_reports, [&](std::string_view suffix) {
               return name.size() >= suffix.size() &&
                      equal_in_any_case(suffix, name.substr(name.size() - suffix.size()));
           });
}

std::string derived_id(std::string_view name)
{
    constexpr std::size_t longest = 96;  // leaves room for a hash
    static const std::map<std::string_view, std::string_view> letters = by_letter();
    std::string id;
    for (std::size_t i = 0; i < name.size() && id.size() < longest;) {
        const std::string_view character = name.substr(i, size_of(name[i]));
        const auto letter = letters.find(character);
        if (letter != letters.end()) {
            id += letter->second;
        } else if (is_submission_id(name.substr(i, 1)) || name[i] == '.') {
            id += name[i];
        } else if (!is_combining_accent(character)) {
            if (!id.ends_with('-')) id += '-';
            ++i;  // a damaged character may be shorter than its first byte says
            continue;
        }
        i += character.size();
    }
    const auto is_edge = [](char c) { return c == '-' || c == '.' || c == '_'; };
    while (!id.empty() && is_edge(id.back())) id.pop_back();
    id.erase(id.begin(), std::ranges::find_if_not(id, is_edge));
    if (is_reserved_id(id)) std::ranges::replace(id, '.', '-');
    if (is_reserved_id(id)) id.insert(0, "id-");
    return id;
}

std::string short_hash(std::string_view name) { return sha256_hex(name).substr(0, 8); }

}
