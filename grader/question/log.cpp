#include "question/log.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>

#include <umbral/record/questions.hpp>

namespace umbral::grader {
namespace {

std::string_view text_of(const Recorder::Tensors& tensors, std::string_view name)
{
    const auto found = tensors.find(name);
    if (found == tensors.end() || found->second.element != Element::uint8) return {};
    return {reinterpret_cast<const char*>(found->second.bytes.data()), found->second.bytes.size()};
}

template <class Number>
std::vector<Number> numbers_of(const Tensor& tensor, Element element)
{
    if (tensor.element != element) return {};
    std::vector<Number> numbers(tensor.bytes.size() / sizeof(Number));
    if (!numbers.empty()) std::memcpy(numbers.data(), tensor.bytes.data(), tensor.bytes.size());
    return numbers;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t place = 0; place <= text.size();) {
        const std::size_t end = std::min(text.find(separator, place), text.size());
        parts.push_back(text.substr(place, end - place));
        place = end + 1;
    }
    return parts;
}

/// The lines of a text that ends in a line break.
std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines = split(text, '\n');
    if (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

void read_code(std::string_view text, QuestionLog& log)
{
    for (const std::string_view line : lines_of(text)) {
        const std::size_t tab = line.find('\t');
        std::uint32_t number = 0;
        if (tab == std::string_view::npos || std::from_chars(line.data(), line.data() + tab, number).ec != std::errc())
            continue;
        std::string& code = log.code[number] = line.substr(tab + 1);
        std::ranges::replace(code, question_names::line_break, '\n');
    }
}

std::vector<QuestionKind> kinds_in(const Recorder::Tensors& tensors, std::string_view names, std::string_view table)
{
    std::vector<QuestionKind> kinds;
    for (const std::string_view line : lines_of(text_of(tensors, names))) {
        const std::vector<std::string_view> words = split(line, '\t');
        QuestionKind kind{std::string(words.front()), {}, {}, {}};
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::vector<std::string_view> named = split(words[i], Features::before_word);
            kind.features.emplace_back(named.front());
            kind.words.emplace_back(named.begin() + 1, named.end());
        }
        const auto found = tensors.find(std::string(table) + std::to_string(kinds.size()));
        if (found != tensors.end() && found->second.components == words.size()) {
            const std::vector<double> rows = numbers_of<double>(found->second, Element::float64);
            for (std::size_t i = 0; i + words.size() <= rows.size(); i += words.size()) {
                // A student's run may have written anything.
                if (!(rows[i] >= 0 && rows[i] <= std::numeric_limits<std::uint32_t>::max())) continue;
                const auto first = rows.begin() + static_cast<std::ptrdiff_t>(i);
                kind.questions[static_cast<std::uint32_t>(rows[i])].assign(
                    first + 1, first + static_cast<std::ptrdiff_t>(words.size()));
            }
        }
        kinds.push_back(std::move(kind));
    }
    return kinds;
}

std::vector<QuestionTile> tiles_in(const std::vector<std::uint32_t>& numbers)
{
    constexpr std::size_t each = 7;
    std::vector<QuestionTile> tiles;
    for (std::size_t i = 0; i + each <= numbers.size(); i += each)
        tiles.push_back({{numbers[i], numbers[i + 1]},
                         numbers[i + 2],
                         numbers[i + 3],
                         numbers[i + 4],
                         numbers[i + 5],
                         numbers[i + 6]});
    return tiles;
}

bool holds(const QuestionTile& tile, std::size_t cell)
{
    if (tile.columns == 0) return false;
    const std::size_t x = cell % tile.columns;
    const std::size_t y = cell / tile.columns;
    return x >= tile.x && x - tile.x < tile.width && y >= tile.y && y - tile.y < tile.height;
}

std::vector<OtherQuestion> others_in(std::string_view text)
{
    std::vector<OtherQuestion> others;
    for (const std::string_view line : lines_of(text)) {
        const std::vector<std::string_view> words = split(line, '\t');
        if (words.size() == 4)
            others.push_back(
                {std::string(words[0]), std::string(words[1]), std::string(words[2]), std::string(words[3])});
    }
    return others;
}

void read_histories(std::string_view text, QuestionLog& log)
{
    for (const std::string_view line : lines_of(text)) {
        const std::vector<std::string_view> words = split(line, '\t');
        log.histories[std::string(words.front())].assign(words.begin() + 1, words.end());
    }
}

}

std::optional<std::uint32_t> QuestionLog::question_of(std::string_view value, std::size_t cell, std::size_t cells) const
{
    if (!rows.contains(value) && cells == 0) return std::nullopt;
    const QuestionSpan known = questions_of(value, cell, cells);
    return known.count == 1 ? std::optional(known.first) : std::nullopt;
}

QuestionSpan QuestionLog::questions_of(std::string_view value, std::size_t cell, std::size_t cells) const
{
    if (const auto found = rows.find(value); found != rows.end()) {
        const bool known = cell < found->second.size() && found->second[cell] > 0;
        return known ? QuestionSpan{found->second[cell] - 1, 1} : QuestionSpan{};
    }
    if (const auto found = tiles.find(value); found != tiles.end())
        for (const QuestionTile& tile : found->second)
            if (holds(tile, cell)) return tile.questions;
    const auto found = wholes.find(value);
    if (found == wholes.end()) return {};
    const auto [first, count] = found->second;
    // As many for each cell, or all of them for all.
    if (count < cells || cells == 0 || count % cells != 0 || cell >= cells) return found->second;
    return {first + static_cast<std::uint32_t>(cell * (count / cells)), 1};
}

std::pair<std::size_t, std::size_t> QuestionLog::place_of_row(std::string_view value, std::size_t row) const
{
    const auto found = rows.find(value);
    if (found == rows.end() || row >= found->second.size() || found->second[row] == 0) return {0, 0};
    const std::vector<std::uint32_t>& questions = found->second;
    const auto at = questions.begin() + static_cast<std::ptrdiff_t>(row);
    return {static_cast<std::size_t>(std::count(questions.begin(), at, *at)),
            static_cast<std::size_t>(std::count(questions.begin(), questions.end(), *at))};
}

const QuestionKind* QuestionLog::kind_of(std::uint32_t question) const
{
    for (const QuestionKind& kind : kinds)
        if (kind.questions.contains(question)) return &kind;
    return nullptr;
}

QuestionLog read_questions(const Recorder::Tensors& tensors)
{
    QuestionLog log;
    for (const auto& [name, tensor] : tensors) {
        if (name.starts_with(question_names::rows))
            log.rows[name.substr(question_names::rows.size())] = numbers_of<std::uint32_t>(tensor, Element::uint32);
        if (name.starts_with(question_names::tiles))
            log.tiles[name.substr(question_names::tiles.size())] =
                tiles_in(numbers_of<std::uint32_t>(tensor, Element::uint32));
        if (!name.starts_with(question_names::whole)) continue;
        if (const auto span = numbers_of<std::uint32_t>(tensor, Element::uint32); span.size() == 2)
            log.wholes[name.substr(question_names::whole.size())] = {span[0], span[1]};
    }
    read_code(text_of(tensors, question_names::code), log);
    log.kinds = kinds_in(tensors, question_names::functions, question_names::features);
    log.sized = kinds_in(tensors, question_names::sized, question_names::sizes);
    log.others = others_in(text_of(tensors, question_names::others));
    log.moves = others_in(text_of(tensors, question_names::moves));
    read_histories(text_of(tensors, question_names::histories), log);
    return log;
}

}
