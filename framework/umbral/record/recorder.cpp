#include <cstring>
#include <stdexcept>
#include <umbral/record/questions.hpp>
#include <umbral/record/recorder.hpp>

namespace umbral {
namespace {

template <class Value>
void add_bytes(Tensor& tensor, const Value& value)
{
    const std::size_t old = tensor.bytes.size();
    tensor.bytes.resize(old + sizeof value);
    std::memcpy(tensor.bytes.data() + old, &value, sizeof value);
}

}

// From the first optional row on `present` has a byte for each row: those that are no optional rows are there.
Tensor& Recorder::row(std::string_view name, Element element, std::uint32_t components, bool optional)
{
    auto found = tensors_.find(name);
    if (found == tensors_.end()) {
        found = tensors_.emplace(std::string(name), Tensor{element, 0, 1, components, {}, {}}).first;
    } else {
        const Tensor& tensor = found->second;
        if (tensor.element != element || tensor.components != components || tensor.columns != 1)
            throw std::logic_error("Recorder: '" + std::string(name) +
                                   "' was recorded before with another type or shape");
    }
    Tensor& table = found->second;
    if (optional) table.present.resize(table.rows, 1);
    ++table.rows;
    if (!optional && !table.present.empty()) table.present.push_back(1);
    if (questions_ != nullptr) questions_->link_row(name);
    if (progress_ != nullptr) progress_->add_row(name, table.rows - 1);
    return table;
}

void Recorder::append(std::string_view name, float value) { add_bytes(row(name, Element::float32, 1, false), value); }
void Recorder::append(std::string_view name, double value) { add_bytes(row(name, Element::float64, 1, false), value); }
void Recorder::append(std::string_view name, std::int32_t value)
{
    add_bytes(row(name, Element::int32, 1, false), value);
}
void Recorder::append(std::string_view name, std::uint32_t value)
{
    add_bytes(row(name, Element::uint32, 1, false), value);
}
void Recorder::append(std::string_view name, glm::vec2 value)
{
    add_bytes(row(name, Element::float32, 2, false), value);
}
void Recorder::append(std::string_view name, glm::vec3 value)
{
    add_bytes(row(name, Element::float32, 3, false), value);
}
void Recorder::append(std::string_view name, glm::vec4 value)
{
    add_bytes(row(name, Element::float32, 4, false), value);
}
void Recorder::append(std::string_view name, glm::dvec2 value)
{
    add_bytes(row(name, Element::float64, 2, false), value);
}
void Recorder::append(std::string_view name, const glm::mat3& value)
{
    add_bytes(row(name, Element::float32, 9, false), value);
}
void Recorder::append(std::string_view name, const glm::mat4& value)
{
    add_bytes(row(name, Element::float32, 16, false), value);
}

template <class Value>
void Recorder::optional_row(std::string_view name, Element element, const std::optional<Value>& value)
{
    const auto components = static_cast<std::uint32_t>(sizeof(Value) / size_of(element));
    Tensor& tensor = row(name, element, components, true);
    add_bytes(tensor, value.value_or(Value(0)));
    tensor.present.push_back(value.has_value() ? 1 : 0);
}

void Recorder::append(std::string_view name, std::optional<float> value)
{
    optional_row(name, Element::float32, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::vec2>& value)
{
    optional_row(name, Element::float32, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::vec3>& value)
{
    optional_row(name, Element::float32, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::vec4>& value)
{
    optional_row(name, Element::float32, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::dvec2>& value)
{
    optional_row(name, Element::float64, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::dvec3>& value)
{
    optional_row(name, Element::float64, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::ivec2>& value)
{
    optional_row(name, Element::int32, value);
}
void Recorder::append(std::string_view name, const std::optional<glm::mat4>& value)
{
    optional_row(name, Element::float32, value);
}

void Recorder::append(std::string_view name, std::span<const float> values)
{
    if (values.empty())
        throw std::logic_error("Recorder: '" + std::string(name) +
                               "': expected a row of at least one number, got an empty one");
    Tensor& tensor = row(name, Element::float32, static_cast<std::uint32_t>(values.size()), false);
    for (const float value : values) add_bytes(tensor, value);
}

void Recorder::columns(std::string_view name, std::string_view names)
{
    const std::string key = std::string(name) + ".names";
    if (!tensors_.contains(key)) text(key, names);
}

void Recorder::refused(std::string_view name, std::string_view why)
{
    constexpr std::size_t most_letters = 200;
    const auto found = tensors_.find(name);
    const std::uint32_t row = found == tensors_.end() ? 0 : found->second.rows;
    std::string& lines = refusals_[std::string(name)];
    if (lines.size() + most_letters > refusals::most_bytes) return;
    lines += std::to_string(row) + '\t';
    for (const char letter : why.substr(0, most_letters)) lines += letter == '\n' || letter == '\t' ? ' ' : letter;
    lines += '\n';
}

void Recorder::text(std::string_view name, std::string_view text)
{
    whole(name, Element::uint8, 1, static_cast<int>(text.size()), 1, text.data());
}

void Recorder::whole(std::string_view name, Element element, int width, int height, std::uint32_t components,
                     const void* data)
{
    Tensor tensor{element, static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(width), components, {}, {}};
    tensor.bytes.resize(tensor.count() * size_of(element));
    if (!tensor.bytes.empty()) std::memcpy(tensor.bytes.data(), data, tensor.bytes.size());
    if (!tensors_.emplace(std::string(name), std::move(tensor)).second)
        throw std::logic_error("Recorder: '" + std::string(name) + "' was recorded before; a picture is recorded once");
    if (questions_ != nullptr) questions_->link_whole(name);
}

void Recorder::finish()
{
    for (const auto& [name, lines] : refusals_) text(name + std::string(refusals::suffix), lines);
    if (questions_ != nullptr) questions_->write(tensors_);
    if (progress_ != nullptr) progress_->write(tensors_);
}

void Recorder::image(std::string_view name, const Grid<glm::u8vec4>& picture)
{
    whole(name, Element::uint8, picture.width, picture.height, 4, picture.cells.data());
}
void Recorder::image(std::string_view name, const Grid<glm::vec3>& picture)
{
    whole(name, Element::float32, picture.width, picture.height, 3, picture.cells.data());
}
void Recorder::buffer(std::string_view name, const Grid<std::uint32_t>& cells)
{
    whole(name, Element::uint32, cells.width, cells.height, 1, cells.cells.data());
}
void Recorder::buffer(std::string_view name, const Grid<float>& cells)
{
    whole(name, Element::float32, cells.width, cells.height, 1, cells.cells.data());
}

void Recorder::tile(std::string_view name, int x, int y, int width, int height, unsigned questions)
{
    if (questions_ != nullptr) questions_->link_tile(name, x, y, width, height, questions);
}

}
