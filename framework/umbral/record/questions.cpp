#include "umbral/record/questions.hpp"

#include <algorithm>
#include <utility>

#include "umbral/record/tensor_of.hpp"

namespace umbral {
namespace {

constexpr std::size_t most_code = std::size_t{4} << 20U;
constexpr std::size_t most_numbers = std::size_t{1} << 20U;  ///< of features, in one table
constexpr std::size_t lines_shown = 12;
constexpr std::size_t longest_name = 64;

std::string line_of(const OtherQuestion& one)
{
    return one.function + '\t' + one.place + '\t' + one.change + '\t' + one.other + '\n';
}

}

// Never inlined, and never empty for the linker: a breakpoint must find it.
[[gnu::noinline]] void question_reached() { asm volatile(""); }

void Questions::begin()
{
    ++count_;
    if (noted_) noted_();
    if (inquiry_.stop && *inquiry_.stop + 1 == count_) question_reached();
}

bool Questions::code_is_wanted() const { return count_ > 0 && std::ranges::binary_search(inquiry_.wanted, count_ - 1); }

void Questions::set_code(std::string_view code)
{
    if (code_.size() + code.size() > most_code) return;
    code_ += std::to_string(count_ - 1) + '\t';
    for (const char letter : code) code_ += letter == '\n' ? question_names::line_break : letter;
    code_ += '\n';
}

bool Questions::knows(std::string_view function) const
{
    return std::ranges::find(functions_, function, &Function::name) != functions_.end();
}

void Questions::introduce(std::string_view function, const Features& features, std::span<const Part> parts)
{
    functions_.push_back({std::string(function), features.names, {}});
    for (const OtherQuestion& one : other_questions(function, parts)) others_ += line_of(one);
    for (const OtherQuestion& one : moved_questions(function, parts)) moves_ += line_of(one);
}

void Questions::may_leave_out(std::string_view function)
{
    if (!inquiry_.questions || !may_be_left_out_.emplace(function).second) return;
    others_ += line_of({std::string(function), "", std::string(left_out), ""});
}

void Questions::set_features(std::string_view function, const Features& features)
{
    add_numbers(*std::ranges::find(functions_, function, &Function::name), features);
}

bool Questions::knows_sizes(std::string_view function) const
{
    return std::ranges::find(sized_, function, &Function::name) != sized_.end();
}

void Questions::set_sizes(std::string_view function, const Features& sizes)
{
    if (sizes.values.empty()) return;
    if (!knows_sizes(function)) sized_.push_back({std::string(function), sizes.names, {}});
    add_numbers(*std::ranges::find(sized_, function, &Function::name), sizes);
}

void Questions::add_numbers(Function& found, const Features& features) const
{
    // Of overloads, those that are called like the first one; and of very many questions, the first.
    if (features.values.size() != found.features.size()) return;
    if (found.table.size() + features.values.size() > most_numbers) return;
    found.table.push_back(count_ - 1);
    found.table.insert(found.table.end(), features.values.begin(), features.values.end());
}

void Questions::set_object(const void* object, std::string_view name, std::string made)
{
    std::optional<Line> same;
    for (const auto& [address, before] : objects_)
        if (before.name == name && before.lines.size() == 1 && before.lines.front().text == made)
            same = before.lines.front();
    std::erase_if(objects_, [&](const auto& one) { return one.second.name == name; });
    // Made again by the same line, with nothing done to it: in the text it is the same, before all that used it.
    objects_[object] = {std::string(name), {same ? *same : Line{lines_++, std::move(made)}}, 0};
}

std::string Questions::name_of(const void* object) const
{
    const auto found = objects_.find(object);
    return found == objects_.end() ? std::string() : found->second.name;
}

std::string Questions::history() const
{
    std::map<std::size_t, std::string> lines;
    for (const auto& [address, object] : objects_) {
        for (const Line& line : object.lines) lines[line.number] = line.text + '\n';
        if (object.left_out > 0)
            lines[object.lines.front().number] += "// … " + std::to_string(object.left_out) +
                                                  (object.left_out == 1 ? " call " : " calls ") +
                                                  (objects_.size() > 1 ? "to " + object.name + ' ' : "") + "left out\n";
    }
    std::string text;
    for (const auto& [number, line] : lines) text += line;
    return text;
}

void Questions::add_line(const void* object, std::string line)
{
    const auto found = objects_.find(object);
    if (found == objects_.end()) return;
    Object& known = found->second;
    if (!inquiry_.in_full && known.lines.size() == lines_shown) {
        known.lines.erase(known.lines.begin() + 1);
        ++known.left_out;
    }
    known.lines.push_back({lines_++, std::move(line)});
}

void Questions::note_change(std::string_view function)
{
    if (inquiry_.questions && !changing_.contains(function)) changing_.emplace(function);
}

void Questions::note_object(std::string_view function)
{
    if (!inquiry_.questions || changing_.empty()) return;
    const auto found = histories_.try_emplace(std::string(function)).first;
    if (found->second.size() != changing_.size()) found->second = changing_;
}

void Questions::link_row(std::string_view value)
{
    const auto found = rows_.find(value);
    (found != rows_.end() ? found : rows_.emplace(std::string(value), std::vector<std::uint32_t>()).first)
        ->second.push_back(count_);
}

void Questions::link_whole(std::string_view value)
{
    // Several pictures of the same questions: ids and normals, say.
    if (count_ != whole_to_) whole_from_ = std::exchange(whole_to_, count_);
    wholes_[std::string(value)] = {whole_from_, whole_to_ - whole_from_};
}

void Questions::link_tile(std::string_view value, int x, int y, int width, int height, std::uint32_t questions)
{
    const auto number = [](int n) { return static_cast<std::uint32_t>(n); };
    const std::uint32_t count = std::min(questions, count_);
    tiles_[std::string(value)].push_back({count_ - count, count, number(x), number(y), number(width), number(height)});
}

void Questions::write_tables(const std::vector<Function>& functions, std::string_view names, std::string_view table,
                             std::map<std::string, Tensor, std::less<>>& tensors)
{
    std::string lines;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        lines += functions[i].name;
        for (const std::string& feature : functions[i].features) lines += '\t' + feature;
        lines += '\n';
        tensors[std::string(table) + std::to_string(i)] =
            tensor_of<double>(functions[i].table, functions[i].features.size() + 1);
    }
    tensors[std::string(names)] = tensor_of<char>(lines);
}

void Questions::write(std::map<std::string, Tensor, std::less<>>& tensors) const
{
    const auto add = [&](const std::string& name, Tensor tensor) {
        if (name.size() <= longest_name) tensors[name] = std::move(tensor);
    };
    for (const auto& [value, rows] : rows_)
        add(std::string(question_names::rows) + value, tensor_of<std::uint32_t>(rows, 1));
    for (const auto& [value, span] : wholes_) {
        const std::uint32_t numbers[] = {span.first, span.second};
        add(std::string(question_names::whole) + value, tensor_of<std::uint32_t>(numbers, 2));
    }
    for (const auto& [value, tiles] : tiles_) {
        const auto picture = tensors.find(value);
        if (picture == tensors.end()) continue;
        std::vector<std::uint32_t> rows;
        for (const auto& tile : tiles) {
            rows.insert(rows.end(), tile.begin(), tile.end());
            rows.push_back(picture->second.columns);
        }
        add(std::string(question_names::tiles) + value, tensor_of<std::uint32_t>(rows, 7));
    }
    write_tables(functions_, question_names::functions, question_names::features, tensors);
    write_tables(sized_, question_names::sized, question_names::sizes, tensors);
    std::string histories;
    for (const auto& [function, changing] : histories_) {
        histories += function;
        for (const std::string& one : changing) histories += '\t' + one;
        histories += '\n';
    }
    add(std::string(question_names::histories), tensor_of<char>(histories));
    add(std::string(question_names::code), tensor_of<char>(code_));
    add(std::string(question_names::others), tensor_of<char>(others_));
    add(std::string(question_names::moves), tensor_of<char>(moves_));
}

}
